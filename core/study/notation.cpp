#include "core/study/notation.h"

#include <fmt/format.h>

#include "core/study/wording.h"

namespace eyeray {
namespace {

constexpr std::size_t kTerms = static_cast<std::size_t>(Term::Background) + 1;
using Symbols = std::array<const char*, kTerms>; // in order of Term

constexpr Symbols kDeckA = {"L", "L", "Le", "ka Ia", "",   "",  "kd (l·n)",  "ks (r·v)^sh",
                            "I", "S", "",   "",      "kr", "T", "background"};
constexpr Symbols kDeckB = {"colour", "colour",  "emission",     "ambient",     "",
                            "",       "diffuse", "specular",     "light",       "shadow ray",
                            "",       "",        "reflectivity", "attenuation", "background"};
constexpr Symbols kGlm = {"color",
                          "color",
                          "emission",
                          "ka * Ia",
                          "",
                          "",
                          "kd * dot(n, l)",
                          "ks * pow(dot(reflect(-l, n), v), sh)",
                          "light",
                          "visible",
                          "",
                          "",
                          "kr",
                          "exp(-sigma * d)",
                          "sky"};

const Symbols& symbolsOf(Notation notation) {
    constexpr std::array<const Symbols*, 3> kAll = {&kDeckA, &kDeckB, &kGlm};
    return *kAll[static_cast<std::size_t>(notation)];
}

/// What the physical methods call otherwise: w weighs the shadow ray against the ray that may find the lamp,
/// p is the density with which a ray was sent. Null for all else.
const char* physicalSymbol(Term term, Notation notation) {
    const bool glm = notation == Notation::Glm, words = notation == Notation::DeckB;
    if (term == Term::Emission) return words ? "weight emission" : glm ? "w * emission" : "w Le";
    if (term == Term::Diffuse) return words ? "diffuse" : glm ? "w * fd * dot(n, l)" : "w fd (l·n)";
    if (term == Term::Specular) return words ? "glossy" : glm ? "w * fs * dot(n, l)" : "w fs (l·n)";
    if (term == Term::Share) return words ? "f cos / pdf" : glm ? "f * dot(n, l) / p" : "f cos/p";
    if (term == Term::Background) return words ? "weight background" : glm ? "w * sky" : "w background";
    return nullptr;
}

bool isParenthesis(Term term) {
    return term == Term::Radiance || term == Term::Arriving || term == Term::Local || term == Term::Onward;
}

std::string subscript(int number) {
    std::string result;
    for (const char digit : fmt::format("{}", number)) {
        result += "\xE2\x82"; // U+2080 and on, in UTF-8
        result += static_cast<char>('\x80' + (digit - '0'));
    }
    return result;
}

std::string numbered(const std::string& symbol, int light, Notation notation) {
    if (light < 0) return symbol;
    if (notation == Notation::DeckA) return symbol + subscript(light + 1);
    if (notation == Notation::DeckB) return fmt::format("{} {}", symbol, light + 1);
    return fmt::format("{}[{}]", symbol, light);
}

/// Whether the highlight at a hit is (n·h)^sh rather than (r·v)^sh.
bool usesHalfVector(const Scene& scene, int material) {
    if (material < 0 || static_cast<std::size_t>(material) >= scene.materials.size()) return false;
    const MaterialModel& model = scene.materials[static_cast<std::size_t>(material)].model;
    const auto* taught = std::get_if<TaughtMaterial>(&model);
    return taught == nullptr || taught->specularModel == SpecularModel::BlinnPhong;
}

void collect(const Ledger& ledger, int node, std::vector<LedgerLine>& lines) {
    const std::vector<int> operands = ledger.operandsOf(node);
    const bool factor = ledger.at(node).operation == LedgerNode::Operation::Product && operands.size() > 1;
    for (const int operand : operands) {
        if (isParenthesis(ledger.at(operand).term))
            collect(ledger, operand, lines);
        else
            lines.push_back({operand, factor});
    }
}

}

std::string LedgerText::symbol(int node) const {
    const LedgerNode& n = ledger.at(node);
    const RayRecord& ray = record.rays[static_cast<std::size_t>(n.ray)];
    const char* const physical = record.physical ? physicalSymbol(n.term, notation) : nullptr;
    if (physical != nullptr) return physical;
    if (n.term == Term::Specular && usesHalfVector(scene, ray.hit.material)) {
        if (notation == Notation::DeckA) return "ks (n·h)^sh";
        if (notation == Notation::Glm) return "ks * pow(dot(n, h), sh)";
    }
    if (n.term == Term::Share && ray.kind == RayKind::Refraction)
        return notation == Notation::DeckB ? "transparency" : "kt";
    const std::string plain = symbolsOf(notation)[static_cast<std::size_t>(n.term)];
    const bool ofLamp = n.term == Term::Irradiance || n.term == Term::Visibility;
    return ofLamp ? numbered(plain, record.lamps[static_cast<std::size_t>(n.lamp)].light, notation) : plain;
}

template <class Leaf>
std::string LedgerText::expression(int node, bool alone, const Leaf& leaf) const {
    const LedgerNode& n = ledger.at(node);
    if (n.operation == LedgerNode::Operation::Value) return leaf(node);
    const bool sum = n.operation == LedgerNode::Operation::Sum;
    const std::vector<int> operands = ledger.operandsOf(node);
    std::string result;
    int parts = 0;
    for (const int operand : operands) {
        const LedgerNode& o = ledger.at(operand);
        if (isBlack(o.value) && (o.term == Term::Emission || (o.term == Term::Ambient && record.physical)))
            continue;
        if (parts++ > 0) result += sum ? " + " : (notation == Notation::Glm ? " * " : " · ");
        const bool cut = o.term == Term::Radiance;
        result += cut ? leaf(operand) : expression(operand, sum || operands.size() == 1, leaf);
    }
    return sum && !alone && parts > 1 ? "(" + result + ")" : result;
}

std::string LedgerText::formula(int node) const {
    return expression(node, true, [&](int leaf) {
        return ledger.at(leaf).term == Term::Radiance ? std::string("[…]") : symbol(leaf);
    });
}

std::string LedgerText::numbers(int node) const {
    return expression(node, true, [&](int leaf) { return amountText(ledger.at(leaf).value); });
}

std::string LedgerText::whose(int node) const {
    const LedgerNode& n = ledger.at(node);
    if (n.lamp >= 0) {
        const LampTerm& lamp = record.lamps[static_cast<std::size_t>(n.lamp)];
        std::string name = lampName(scene, lamp.light);
        if (n.term != Term::Lamp) return name;
        if (lamp.state == LampTerm::State::FacesAway) return name + ", behind the surface";
        if (lamp.state == LampTerm::State::OutOfReach) return name + ", out of reach";
        if (isBlack(lamp.visibility)) return name + ", blocked";
        return name;
    }
    const RayRecord& ray = record.rays[static_cast<std::size_t>(n.ray)];
    if (n.term == Term::Sent || n.term == Term::Radiance)
        return fmt::format("{} ray: {}", name(ray.kind), meeting(scene, ray));
    if (n.term == Term::Transmittance) return objectName(scene, ray.medium);
    return {};
}

bool LedgerText::saysNothing(int node) const {
    const LedgerNode& n = ledger.at(node);
    switch (n.term) {
    case Term::Share:
        return true;
    case Term::Transmittance:
        return n.value == Color(1);
    case Term::Emission:
    case Term::Ambient:
        return isBlack(n.value);
    case Term::Lamp:
        return n.ray > 0 && record.lamps[static_cast<std::size_t>(n.lamp)].state != LampTerm::State::Lit;
    default:
        return false;
    }
}

std::vector<LedgerLine> linesBelow(const Ledger& ledger, int node) {
    std::vector<LedgerLine> lines;
    collect(ledger, node, lines);
    return lines;
}

}
