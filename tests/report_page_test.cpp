// labels: unit
#include "core/study/report_page.h"

#include <gtest/gtest.h>

using namespace eyeray;

TEST(ReportPage, HoldsItsPartsInOrderAndNeedsNoOtherFile) {
    ReportPage page("Speed & accuracy", "of <homage>");
    page.section("Chart");
    page.figure("<svg></svg>", "a \"chart\"");
    page.table({{"method", "seconds"}, {{{"path", "0.5"}, false}, {{"whitted", "-"}, true}}});
    page.pictures(
        std::vector<ReportPicture>{{{std::byte{'a'}, std::byte{'b'}, std::byte{'c'}}, "one", "two"}});
    page.paragraph("end");
    const std::string file = page.file();
    std::size_t at = 0;
    for (const char* part :
         {"<title>Speed &amp; accuracy</title>", "<h1>Speed &amp; accuracy</h1>", "of &lt;homage&gt;",
          "<h2>Chart</h2>", "<svg></svg>", "a &quot;chart&quot;", "<th class=\"number\">seconds</th>",
          "<tr><td>path</td><td class=\"number\">0.5</td></tr>", "<tr class=\"marked\">",
          "data:image/png;base64,YWJj", "<p>end</p>", "</html>"}) {
        const std::size_t found = file.find(part, at);
        ASSERT_NE(found, std::string::npos) << part;
        at = found;
    }
    EXPECT_EQ(file.find("http"), std::string::npos);
    EXPECT_EQ(file.find("src=\"/"), std::string::npos);
}
