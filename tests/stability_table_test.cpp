// labels: unit
// tests/STABILITY.md has a line for each known failure, and names tests that exist.

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace eyeray {
namespace {

namespace fs = std::filesystem;

const fs::path kTests = fs::path(EYERAY_SOURCE_DIR) / "tests";

std::string textOf(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

/// All matches of the pattern: its first group, and the second after a dot if there is one.
std::multiset<std::string> namesIn(const std::string& text, const std::regex& pattern) {
    std::multiset<std::string> names;
    for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match)
        names.insert(match->size() > 2 ? fmt::format("{}.{}", match->str(1), match->str(2)) : match->str(1));
    return names;
}

TEST(StabilityTable, HasOneLineForEachFailure) {
    const auto lines = namesIn(textOf(kTests / "STABILITY.md"), std::regex(R"(\| (F\d\d) \|)"));
    EXPECT_EQ(lines.size(), 64U);
    for (int i = 1; i <= 64; ++i) EXPECT_EQ(lines.count(fmt::format("F{:02}", i)), 1U) << i;
}

TEST(StabilityTable, NamesTestsThatExist) {
    std::multiset<std::string> tests;
    for (const auto& file : fs::directory_iterator(kTests))
        if (file.path().extension() == ".cpp")
            tests.merge(namesIn(textOf(file.path()), std::regex(R"(TEST(?:_F|_P)?\((\w+),\s*(\w+)\))")));
    const auto named = namesIn(textOf(kTests / "STABILITY.md"), std::regex(R"(`(\w+)\.(\w+)`)"));
    EXPECT_GT(named.size(), 80U);
    for (const std::string& name : named) EXPECT_TRUE(tests.contains(name)) << name;
}

}
}
