// labels: unit
// tests/STABILITY.md has a line for each known failure, and names tests that exist.

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string_view>

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

/// Reads a text from its start on.
class Reader {
public:
    explicit Reader(std::string_view text) : rest_(text) {}

    /// True, and behind it, if the rest starts so.
    bool take(std::string_view start) {
        if (rest_.substr(0, start.size()) != start) return false;
        rest_.remove_prefix(start.size());
        return true;
    }
    std::string_view word() {
        const auto inWord = [](char c) {
            return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
        };
        const auto end = std::find_if_not(rest_.begin(), rest_.end(), inWord);
        const std::string_view word = rest_.substr(0, static_cast<std::size_t>(end - rest_.begin()));
        rest_.remove_prefix(word.size());
        return word;
    }
    void spaces() { rest_.remove_prefix(std::min(rest_.find_first_not_of(" \n"), rest_.size())); }

private:
    std::string_view rest_;
};

/// What `read` makes of the text behind each `opening`, where that is anything.
template <class Read>
std::multiset<std::string> namesIn(std::string_view text, std::string_view opening, const Read& read) {
    std::multiset<std::string> names;
    for (auto at = text.find(opening); at != text.npos; at = text.find(opening, at + 1))
        if (const std::string name = read(Reader(text.substr(at + opening.size()))); !name.empty())
            names.insert(name);
    return names;
}

/// `F12 |`
std::string failure(Reader text) {
    const std::string_view word = text.word();
    return word.size() == 3 && word[0] == 'F' && text.take(" |") ? std::string(word) : "";
}

/// `Suite.Test` and a backtick
std::string mention(Reader text) {
    const std::string_view suite = text.word();
    if (suite.empty() || !text.take(".")) return "";
    const std::string_view test = text.word();
    return !test.empty() && text.take("`") ? fmt::format("{}.{}", suite, test) : "";
}

/// `_P(Suite, Test)`
std::string definition(Reader text) {
    if (!text.take("(") && !text.take("_F(") && !text.take("_P(")) return "";
    const std::string_view suite = text.word();
    if (!text.take(",")) return "";
    text.spaces();
    return fmt::format("{}.{}", suite, text.word());
}

TEST(StabilityTable, HasOneLineForEachFailure) {
    const auto lines = namesIn(textOf(kTests / "STABILITY.md"), "| ", failure);
    EXPECT_EQ(lines.size(), 64U);
    for (int i = 1; i <= 64; ++i) EXPECT_EQ(lines.count(fmt::format("F{:02}", i)), 1U) << i;
}

TEST(StabilityTable, NamesTestsThatExist) {
    std::multiset<std::string> tests;
    for (const auto& file : fs::directory_iterator(kTests))
        if (file.path().extension() == ".cpp") tests.merge(namesIn(textOf(file.path()), "TEST", definition));
    const auto named = namesIn(textOf(kTests / "STABILITY.md"), "`", mention);
    EXPECT_GT(named.size(), 80U);
    for (const std::string& name : named) EXPECT_TRUE(tests.contains(name)) << name;
}

}
}
