#include <fmt/format.h>

#include "app/cli/inspected.h"
#include "core/study/family.h"
#include "core/study/notation.h"
#include "core/study/path_sum.h"
#include "core/study/wording.h"

namespace eyeray {
namespace {

class Text {
public:
    explicit Text(const Inspected& inspected)
        : inspected_(inspected), scene_(*inspected.world->scene), family_(inspected.trace),
          ledger_{inspected.ledger, inspected.trace, scene_} {}

    std::string write() {
        text_ = inspected_.title() + "\n\nRays: kind, what it meets, t, weight, what it brings\n";
        if (inspected_.trace.rays.empty()) return text_ + "  none\n";
        ray(0, 1);
        text_ += "\nThe sum: " + ledger_.formula(0) + "\n";
        for (const LedgerLine& line : linesBelow(inspected_.ledger, 0)) sumLine(line, 1);
        const Color total = evaluate(inspected_.ledger);
        text_ += fmt::format("  = {} {} {}\n", total.r, total.g, total.b);
        text_ += total == inspected_.film ? "The sum is this sample's value in the film, bit for bit.\n"
                                          : "The sum differs from this sample's value in the film.\n";
        pathSum();
        return text_;
    }

private:
    void indent(int level) { text_.append(static_cast<std::size_t>(level) * 2, ' '); }

    void ray(int index, int level) {
        const RayRecord& r = inspected_.trace.rays[static_cast<std::size_t>(index)];
        indent(level);
        text_ += fmt::format("{} #{}: {}{}, t {}, weight {}, {}\n", name(r.kind), index, meeting(scene_, r),
                             r.totalReflection ? fmt::format(" ({})", kTotalReflectionText) : "",
                             metresText(r.t), weightText(r.weight), colorText(r.radiance));
        indent(level + 1);
        text_ +=
            traversalText(inspected_.traversal[static_cast<std::size_t>(index)], *inspected_.world) + "\n";
        for (const int shadow : family_.shadowRays[index]) ray(shadow, level + 1);
        for (const int next : family_.nextRays[index]) ray(next, level + 1);
        for (const int missing : family_.untraced[index]) {
            const UntracedRay& untraced = inspected_.trace.untraced[static_cast<std::size_t>(missing)];
            indent(level + 1);
            text_ += fmt::format("no {}: {}, weight {}\n", name(untraced.kind), reasonText(untraced.reason),
                                 weightText(untraced.weight));
        }
    }

    void sumLine(const LedgerLine& line, int level) {
        const LedgerNode& node = inspected_.ledger.at(line.node);
        if (ledger_.saysNothing(line.node)) return;
        indent(level);
        const std::string whose = ledger_.whose(line.node);
        text_ += fmt::format("{} {}", line.factor ? "·" : "+", ledger_.formula(line.node));
        if (node.operation == LedgerNode::Operation::Product) text_ += " = " + ledger_.numbers(line.node);
        text_ += " = " + colorText(node.value);
        text_ += whose.empty() ? "\n" : fmt::format("   ({})\n", whose);
        if (node.term != Term::Sent) return;
        for (const LedgerLine& below : linesBelow(inspected_.ledger, line.node)) sumLine(below, level + 1);
    }

    void pathSum() {
        if (!inspected_.trace.physical) return;
        text_ += "\nAs a flat list: throughput · f cos / pdf · MIS weight · radiance · visibility\n";
        const std::vector<PathTerm> terms = pathTermsOf(inspected_.trace);
        for (const PathTerm& term : terms)
            text_ += fmt::format("  + {} = {}   ({})\n", factorsOf(term), colorText(term.value),
                                 wayOf(scene_, inspected_.trace, term));
        text_ += fmt::format("  = {}\n", colorText(Color(sumOf(terms))));
    }

    const Inspected& inspected_;
    const Scene& scene_;
    const Family family_;
    const LedgerText ledger_;
    std::string text_;
};

}

std::string textOf(const Inspected& inspected) { return Text(inspected).write(); }

}
