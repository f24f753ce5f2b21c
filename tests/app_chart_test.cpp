// labels: e2e
// The subcommand `chart`, through the program.

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/image/atomic_file.h"
#include "core/study/pareto.h"
#include "tests/app_process.h"

namespace eyeray {
namespace {

namespace fs = std::filesystem;

struct Said {
    int code;
    std::string out, err;
};

std::string textOf(const fs::path& file) {
    const auto bytes = readFile(file, 1U << 28U);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

using Row = std::map<std::string, std::string>;

/// Cells without quotes alone, as none of these settings needs any.
std::vector<Row> rowsOf(const std::string& csv) {
    std::istringstream lines(csv);
    std::vector<std::vector<std::string>> cells;
    for (std::string line; std::getline(lines, line);) {
        auto& row = cells.emplace_back();
        std::istringstream parts(line + ",");
        for (std::string part; std::getline(parts, part, ',');) row.push_back(part);
    }
    std::vector<Row> rows;
    for (std::size_t i = 1; i < cells.size(); ++i) {
        EXPECT_EQ(cells[i].size(), cells[0].size());
        auto& row = rows.emplace_back();
        for (std::size_t k = 0; k < cells[0].size(); ++k) row[cells[0][k]] = cells[i][k];
    }
    return rows;
}

class ChartCommand : public testing::Test {
protected:
    Said run(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), "chart");
        Process process(EYERAY_BINARY_DIR "/eyeray", arguments, folder.path(),
                        {fmt::format("HOME={}", folder.path().string()),
                         fmt::format("XDG_CACHE_HOME={}/cache", folder.path().string())});
        const int code = process.wait();
        return {code, process.out(), process.err()};
    }

    std::vector<std::string> small(const std::string& output) const {
        return {"homage",   "-o",  output,      "--width", "48",        "--methods", "cast,whitted,path",
                "--depths", "1,3", "--samples", "2,1",     "--repeats", "2",         "--threads",
                "2"};
    }

    const TemporaryFolder folder;
};

TEST_F(ChartCommand, WritesEveryPointAndAPageThatNeedsNoOtherFile) {
    const Said said = run(small("out"));
    ASSERT_EQ(said.code, 0) << said.err;
    const auto rows = rowsOf(textOf(folder.path() / "out/points.csv"));
    ASSERT_EQ(rows.size(), 10U) << "cast has no depth: five curves of two points";
    std::vector<Cost> costs;
    for (const Row& row : rows) {
        EXPECT_EQ(row.at("runs"), "2");
        EXPECT_EQ(row.at("failure"), "");
        for (const char* key : {"seconds", "sampling_rmse", "model_rmse", "model_flip"}) {
            const double median = std::stod(row.at(key));
            EXPECT_GT(median, 0) << key;
            EXPECT_LE(std::stod(row.at(fmt::format("{}_min", key))), median);
            EXPECT_GE(std::stod(row.at(fmt::format("{}_max", key))), median);
        }
        costs.push_back({std::stod(row.at("seconds")), std::stod(row.at("model_rmse"))});
    }
    const auto front = paretoFront(costs);
    for (std::size_t i = 0; i < rows.size(); ++i)
        EXPECT_EQ(rows[i].at("front") == "1", std::ranges::find(front, i) != front.end());

    const std::string svg = textOf(folder.path() / "out/chart.svg"),
                      page = textOf(folder.path() / "out/report.html");
    EXPECT_NE(svg.find("whitted d3 ×2"), std::string::npos);
    EXPECT_NE(svg.find("slope −½: Monte Carlo"), std::string::npos);
    EXPECT_NE(page.find("At equal time"), std::string::npos);
    EXPECT_NE(page.find("data:image/png;base64,"), std::string::npos);
    EXPECT_EQ(page.find("src=\"http"), std::string::npos);
    EXPECT_EQ(page.find(folder.path().string()), std::string::npos);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path() / "out"), {}), 3);
}

TEST_F(ChartCommand, KeepsItsReferencesAndFindsTheSameErrorsAgain) {
    ASSERT_EQ(run(small("first")).code, 0);
    const auto kept = [&] {
        std::map<std::string, fs::file_time_type> files;
        for (const auto& file : fs::directory_iterator(folder.path() / "cache/eyeray/references"))
            files[file.path().filename().string()] = file.last_write_time();
        return files;
    };
    const auto before = kept();
    EXPECT_EQ(before.size(), 6U) << "five models and the fullest";
    ASSERT_EQ(run(small("second")).code, 0);
    EXPECT_EQ(kept(), before);
    const auto first = rowsOf(textOf(folder.path() / "first/points.csv")),
               second = rowsOf(textOf(folder.path() / "second/points.csv"));
    for (std::size_t i = 0; i < first.size(); ++i)
        for (const char* key :
             {"sampling_rmse", "model_rmse", "sampling_reference_error", "model_relmse_max"})
            EXPECT_EQ(first[i].at(key), second[i].at(key));
    // One that is damaged is made anew.
    std::ofstream(folder.path() / "cache/eyeray/references" / before.begin()->first) << "no picture";
    ASSERT_EQ(run(small("third")).code, 0);
    EXPECT_EQ(rowsOf(textOf(folder.path() / "third/points.csv"))[0].at("model_rmse"),
              first[0].at("model_rmse"));
}

TEST_F(ChartCommand, MarksPointsThatAreTooSlowAndLeavesNoneOut) {
    auto arguments = small("out");
    arguments.insert(arguments.end(), {"--limit", "0.001", "--methods", "path", "--reference-samples", "2"});
    arguments.erase(arguments.begin() + 5, arguments.begin() + 7);
    arguments[3] = "--height";
    arguments[4] = "300";
    const Said said = run(arguments);
    ASSERT_EQ(said.code, 0) << said.err;
    const auto rows = rowsOf(textOf(folder.path() / "out/points.csv"));
    ASSERT_EQ(rows.size(), 4U);
    for (const Row& row : rows) EXPECT_EQ(row.at("failure"), "takes longer than 0.001 s");
    const std::string svg = textOf(folder.path() / "out/chart.svg");
    EXPECT_NE(svg.find("path d3 ×2: takes longer than 0.001 s"), std::string::npos);
    EXPECT_NE(said.out.find("failed: takes longer"), std::string::npos);
}

TEST_F(ChartCommand, RefusesWrongListsInOneLine) {
    const std::string longList = [] {
        std::string list = "1";
        for (int i = 2; i < 200; ++i) list += fmt::format(",{}", i);
        return list;
    }();
    const std::vector<std::vector<std::string>> wrong = {
        {"homage"},
        {"homage", "-o", "x", "--methods", "radiosity"},
        {"homage", "-o", "x", "--methods", "path,,cast"},
        {"homage", "-o", "x", "--depths", "1,-1"},
        {"homage", "-o", "x", "--depths", "1e3"},
        {"homage", "-o", "x", "--samples", "0"},
        {"homage", "-o", "x", "--samples", "1,nan"},
        {"homage", "-o", "x", "--samples", longList},
        {"homage", "-o", "x", "--cutoffs", "2"},
        {"homage", "-o", "x", "--accels", "octree"},
        {"homage", "-o", "x", "--metric", "looks"},
        {"homage", "-o", "x", "--repeats", "0"},
        {"homage", "-o", "x", "--limit", "-1"},
        {"no-such-scene", "-o", "x"},
    };
    for (const auto& arguments : wrong) {
        const Said said = run(arguments);
        EXPECT_EQ(said.code, 2) << said.err;
        EXPECT_EQ(std::ranges::count(said.err, '\n'), 1) << said.err;
        EXPECT_FALSE(fs::exists(folder.path() / "x"));
    }
    std::ofstream(folder.path() / "file") << "text";
    EXPECT_EQ(run({"homage", "-o", "file"}).code, 1);
    EXPECT_EQ(run({"homage", "-o", "no/such/folder"}).code, 1);
}

}
}
