#include "core/study/ledger.h"

#include <algorithm>
#include <array>

#include "core/base/thread_pool.h"
#include "core/study/family.h"

namespace eyeray {
namespace {

using Operation = LedgerNode::Operation;

/// Combines the operands of a node. Sums begin at 0 as the tracer's do where it matters: no term is −0 then.
template <class ValueOf>
Color combined(const Ledger& ledger, int node, const ValueOf& valueOf) {
    const bool sum = ledger.at(node).operation == Operation::Sum;
    Color result(sum ? 0.0F : 1.0F);
    for (int i = node + 1; i < ledger.at(node).end; i = ledger.at(i).end)
        sum ? result += valueOf(i) : result *= valueOf(i);
    return result;
}

/// Writes the nodes of a record, each before its operands.
class Writer {
public:
    explicit Writer(const SampleRecord& record) : record_(record), family_(record) {}

    Ledger write() {
        if (!record_.rays.empty()) radiance(0);
        return std::move(ledger_);
    }

private:
    template <class Operands>
    void node(Operation operation, Term term, int ray, int lamp, const Operands& operands) {
        const auto index = ledger_.nodes.size();
        ledger_.nodes.push_back({.operation = operation, .term = term, .ray = ray, .lamp = lamp});
        operands();
        ledger_.nodes[index].end = static_cast<int>(ledger_.nodes.size());
        ledger_.nodes[index].value =
            combined(ledger_, static_cast<int>(index), [&](int i) { return ledger_.at(i).value; });
    }

    void value(Term term, int ray, const Color& result, int lamp = -1) {
        const int end = static_cast<int>(ledger_.nodes.size()) + 1;
        ledger_.nodes.push_back({Operation::Value, term, ray, lamp, end, result});
    }

    void radiance(int index) {
        const RayRecord& ray = record_.rays[static_cast<std::size_t>(index)];
        node(Operation::Product, Term::Radiance, index, -1, [&] {
            if (ray.medium >= 0) value(Term::Transmittance, index, ray.transmitted);
            if (ray.end == RayEnd::Hit)
                arriving(index, ray);
            else
                value(Term::Background, index, ray.background);
        });
    }

    void arriving(int index, const RayRecord& ray) {
        node(Operation::Sum, Term::Arriving, index, -1, [&] {
            value(Term::Emission, index, ray.hit.emission);
            value(Term::Ambient, index, ray.hit.ambient);
            for (const int lamp : family_.lamps[index]) lampTerm(index, lamp);
            const auto next = family_.nextRays[index];
            if (next.size() == 1) sent(next[0]);
            if (next.size() > 1)
                node(Operation::Sum, Term::Onward, index, -1,
                     [&] { std::for_each(next.begin(), next.end(), [&](int r) { sent(r); }); });
        });
    }

    void lampTerm(int ray, int index) {
        const LampTerm& lamp = record_.lamps[static_cast<std::size_t>(index)];
        node(Operation::Product, Term::Lamp, ray, index, [&] {
            node(Operation::Sum, Term::Local, ray, index, [&] {
                value(Term::Diffuse, ray, lamp.diffuse, index);
                value(Term::Specular, ray, lamp.specular, index);
            });
            value(Term::Irradiance, ray, lamp.irradiance, index);
            value(Term::Visibility, ray, lamp.visibility, index);
        });
    }

    void sent(int ray) {
        node(Operation::Product, Term::Sent, ray, -1, [&] {
            value(Term::Share, ray, record_.rays[static_cast<std::size_t>(ray)].share);
            radiance(ray);
        });
    }

    const SampleRecord& record_;
    const Family family_;
    Ledger ledger_;
};

/// Value of a node; where nothing in it is struck out and not all is asked for, the one on record.
Color resultOf(const Ledger& ledger, int node, std::span<const Strike> strikes, bool all) {
    const auto first = std::lower_bound(strikes.begin(), strikes.end(), node,
                                        [](const Strike& strike, int n) { return strike.node < n; });
    const bool struck = first != strikes.end() && first->node < ledger.at(node).end;
    if (struck && first->node == node) return first->value;
    if (ledger.at(node).operation == Operation::Value || (!struck && !all)) return ledger.at(node).value;
    return combined(ledger, node, [&](int i) { return resultOf(ledger, i, strikes, all); });
}

}

std::string_view name(Term term) {
    constexpr std::array<std::string_view, 15> kNames = {
        "radiance",   "arriving",   "emission", "ambient", "lamp",  "local",         "diffuse",   "specular",
        "irradiance", "visibility", "onward",   "sent",    "share", "transmittance", "background"};
    return kNames[static_cast<std::size_t>(term)];
}

std::vector<int> Ledger::operandsOf(int node) const {
    std::vector<int> operands;
    for (int i = node + 1; i < at(node).end; i = at(i).end) operands.push_back(i);
    return operands;
}

Ledger ledgerOf(const SampleRecord& record) {
    const FloatEnvironment environment;
    return Writer(record).write();
}

Color evaluate(const Ledger& ledger, std::span<const Strike> strikes) {
    if (ledger.nodes.empty()) return Color(0);
    const FloatEnvironment environment;
    const Color sum = resultOf(ledger, 0, strikes, strikes.empty());
    return isFinite(sum) ? sum : Color(0);
}

Color valueOf(const Ledger& ledger, int node, std::span<const Strike> strikes) {
    const FloatEnvironment environment;
    return resultOf(ledger, node, strikes, false);
}

Strike strikeOf(const Ledger& ledger, int node) {
    const auto& [operation, term, ray, lamp, end, value] = ledger.at(node);
    const bool lets = term == Term::Transmittance || (term == Term::Visibility && value != Color(1));
    return {node, Color(lets ? 1.0F : 0.0F)};
}

void PixelMean::add(const Color& sample) {
    sum_ = samples_ == 0 ? DVec3(sample) : sum_ + DVec3(sample);
    ++samples_;
}

Color PixelMean::value() const {
    return samples_ > 0 ? Color(sum_ / static_cast<double>(samples_)) : Color(0);
}

}
