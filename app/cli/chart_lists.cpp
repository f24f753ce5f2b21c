#include "app/cli/chart_lists.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/document/command.h"
#include "core/base/errors.h"

namespace eyeray {
namespace {

constexpr int kMostSamples = 1 << 16;
constexpr std::size_t kMostPoints = 500;

class Lists {
public:
    explicit Lists(const std::map<std::string, std::string>& given) : given_(given) {}

    /// Each item as `read` takes it from a command that has it as this key; none twice.
    template <class Value, class Read>
    std::vector<Value> values(std::string_view key, const Read& read) const {
        std::vector<Value> values;
        for (const std::string& item : items(key)) {
            const auto value = static_cast<Value>(read(Command("chart", {{std::string(key), item}})));
            if (std::ranges::find(values, value) == values.end()) values.push_back(value);
        }
        return values;
    }

    template <class Value, class Names>
    std::vector<Value> choices(std::string_view key, const Names& names) const {
        return values<Value>(key, [&](const Command& command) { return *command.choice(key, names); });
    }

    std::vector<int> integers(std::string_view key, int least, int most) const {
        return values<int>(key, [&](const Command& command) { return *command.integer(key, least, most); });
    }

private:
    std::vector<std::string> items(std::string_view key) const {
        const auto given = given_.find(std::string(key));
        const ChartList& list = *std::ranges::find(kChartLists, key, &ChartList::key);
        const std::string text =
            given == given_.end() || given->second.empty() ? std::string(list.usual) : given->second;
        std::vector<std::string> items;
        for (std::size_t from = 0; from <= text.size();) {
            const std::size_t comma = std::min(text.find(',', from), text.size());
            items.push_back(text.substr(from, comma - from));
            from = comma + 1;
        }
        return items;
    }

    const std::map<std::string, std::string>& given_;
};

}

ExperimentGrid gridFrom(const std::map<std::string, std::string>& given, const TraceSettings& base) {
    const Lists lists(given);
    ExperimentGrid grid;
    grid.methods = lists.choices<Method>("methods", kMethodNames);
    grid.depths = lists.integers("depths", 0, kMaxDepth);
    grid.cutoffs = lists.values<float>(
        "cutoffs", [](const Command& command) { return *command.number("cutoffs", 0, 1); });
    grid.samples = lists.integers("samples", 1, kMostSamples);
    grid.accels = lists.choices<AccelKind>("accels", kAccelNames);
    grid.samplers = lists.choices<Sampler>("samplers", kSamplerNames);
    grid.glassShadows = lists.choices<GlassShadows>("glass-shadows", kGlassShadowNames);
    constexpr std::array<std::string_view, 2> kOffOn = {"off", "on"};
    grid.shadows = lists.choices<std::uint8_t>("shadows", kOffOn);
    grid.adaptive = lists.choices<std::uint8_t>("adaptive", kOffOn);
    grid.precisions = lists.choices<Precision>("precisions", kPrecisionNames);
    std::ranges::sort(grid.samples);
    const std::size_t points = combinations(grid, base).size() * grid.samples.size();
    if (points > kMostPoints)
        throw InputError("eyeray chart", fmt::format("these are {} points", points),
                         fmt::format("shorten the lists to {} or fewer", kMostPoints));
    return grid;
}

}
