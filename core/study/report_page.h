#pragma once
// A report as one HTML page that needs no other file: light, dark, and in print.

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace eyeray {

struct ReportTable {
    struct Row {
        std::vector<std::string> cells;
        bool marked = false; // stands out
    };
    std::vector<std::string> head;
    std::vector<Row> rows;
};

struct ReportPicture {
    std::vector<std::byte> png;
    std::string title, caption;
};

struct ReportFigure {
    std::string svg, title, caption;
};

/// All texts are plain and are escaped; parts stand in the order in which they are added.
class ReportPage {
public:
    /// `summary` stands below the title.
    ReportPage(std::string_view title, std::string_view summary);

    void section(std::string_view heading);
    void paragraph(std::string_view text);
    /// Cells that begin like a number stand at the right.
    void table(const ReportTable&);
    /// A whole SVG, as it is, with words below.
    void figure(std::string_view svg, std::string_view caption);
    /// Side by side as the width allows.
    void figures(std::span<const ReportFigure>);
    void pictures(std::span<const ReportPicture>);

    /// The whole file.
    std::string file() const { return body_ + "</main>\n</body>\n</html>\n"; }

private:
    std::string body_;
};

}
