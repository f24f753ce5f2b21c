// labels: unit
// `eyeray stability` as a program; no test asks how fast anything is.

#include <algorithm>
#include <fstream>
#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/study/stability_report.h"
#include "tests/app_process.h"

namespace eyeray {
namespace {

namespace fs = std::filesystem;

class Stability : public testing::Test {
protected:
    Process start(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), "stability");
        return {EYERAY_BINARY_DIR "/eyeray",
                std::move(arguments),
                folder.path(),
                {"HOME=" + folder.path().string()}};
    }
    std::string fileOf(const std::string& name) const {
        std::ostringstream text;
        text << std::ifstream(folder.path() / name).rdbuf();
        return text.str();
    }

    TemporaryFolder folder;
};

TEST_F(Stability, WritesItsReportAndTellsEveryCase) {
    Process stability = start({"-o", "report", "--json", "--rays", "20000"});
    ASSERT_EQ(stability.wait(), 0) << stability.err();
    EXPECT_EQ(stability.err(), "");
    const auto list = nlohmann::json::parse(stability.out());
    ASSERT_EQ(list.size(), stabilityCases().size());
    std::size_t lines = 1;
    for (const auto& json : list) {
        for (const char* key : {"case", "title", "why", "fix", "parameter", "error_is", "failure_is", "mark"})
            EXPECT_TRUE(json.contains(key)) << key;
        EXPECT_EQ(json["passes"], true) << json["case"];
        for (const auto& point : json["points"])
            for (const char* form : {"naive float", "naive double", "robust"}) {
                if (!point.contains(form)) continue;
                ++lines;
                for (const char* key : {"error", "failures_per_million", "nanoseconds"})
                    EXPECT_GE(point[form].at(key).get<double>(), 0) << json["case"] << " " << form;
            }
    }
    EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(fileOf("report/cases.csv"), '\n')), lines);
    const std::string page = fileOf("report/report.html");
    for (const StabilityCase& subject : stabilityCases())
        EXPECT_NE(page.find(fmt::format("{} {}", subject.id, subject.title)), std::string::npos)
            << subject.id;
    EXPECT_EQ(page.find("http://www.w3.org") == page.npos, page.find("<svg") == page.npos);
    EXPECT_EQ(page.find("<script"), std::string::npos);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path() / "report"), {}), 2) << "and nothing else";
}

TEST_F(Stability, PrintsALineForEachCase) {
    Process stability = start({"-o", ".", "--rays", "20000"});
    ASSERT_EQ(stability.wait(), 0) << stability.err();
    for (const StabilityCase& subject : stabilityCases())
        EXPECT_NE(stability.out().find(fmt::format("\n{}  {}", subject.id, subject.title)), std::string::npos)
            << subject.id;
    EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(stability.out(), '\n')),
              stabilityCases().size() + 2);
}

TEST_F(Stability, RefusesAWrongRequestBeforeTheWork) {
    EXPECT_EQ(start({}).wait(), 2) << "no folder";
    EXPECT_EQ(start({"-o", "report", "--rays", "1"}).wait(), 2);
    EXPECT_EQ(start({"-o", "report", "surplus"}).wait(), 2);
    std::ofstream(folder.path() / "file") << "here";
    EXPECT_EQ(start({"-o", "file"}).wait(), 2);
    EXPECT_EQ(start({"-o", "no/such/report"}).wait(), 1);
}

TEST_F(Stability, WritesNothingWhenInterrupted) {
    Process stability = start({"-o", "report", "--rays", "2000000"});
    ASSERT_TRUE(eventually([&] { return fs::exists(folder.path() / "report") || !stability.running(); }));
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    stability.interrupt();
    const int code = stability.wait();
    if (code == 128 + SIGINT) GTEST_SKIP() << "interrupted before it had begun";
    EXPECT_EQ(code, 1);
    EXPECT_EQ(std::ranges::count(stability.err(), '\n'), 1) << stability.err();
    EXPECT_TRUE(fs::is_empty(folder.path() / "report"));
}

TEST(StabilityReport, SaysWhichRobustFormMissesItsMark) {
    StabilityCase strict = stabilityCases().front();
    strict.mark = {-1, 0};
    const std::vector results = {measureCase(strict, {.trials = 1000, .timed = false, .stop = {}})};
    EXPECT_FALSE(results.front().passes());
    EXPECT_NE(stabilityText(results).find("misses its mark"), std::string::npos);
    EXPECT_NE(stabilityPage(results, "").find("0 of 1"), std::string::npos);
}

}
}
