#pragma once
// The ledger in the letters of the lectures.

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/scene/scene.h"
#include "core/study/ledger.h"

namespace eyeray {

/// The letters of deck A, the words of deck B, or the names of GLM and GLSL.
enum class Notation : std::uint8_t { DeckA, DeckB, Glm };
inline constexpr std::array<std::string_view, 3> kNotationNames = {"a", "b", "glm"};
inline constexpr std::array<std::string_view, 3> kNotationLabels = {"deck A: letters", "deck B: words",
                                                                    "GLM names"};

/// What a reader needs besides the ledger to read it.
struct LedgerText {
    const Ledger& ledger;
    const SampleRecord& record;
    const Scene& scene;
    Notation notation = Notation::DeckA;

    /// The symbol of a term: "ka Ia", "ks (r·v)^sh", "kr".
    std::string symbol(int node) const;
    /// A node as a formula: "(kd (l·n) + ks (r·v)^sh) · I₁ · S₁", "kr · […]". What a ray brings is […].
    std::string formula(int node) const;
    /// The same with the numbers filled in: one number for a grey, else "(r g b)".
    std::string numbers(int node) const;
    /// In words, whom it belongs to: the lamp, what the ray that is sent on meets; may be empty.
    std::string whose(int node) const;

    /// A line that tells a reader nothing: a factor that stands in the line above, a medium that takes
    /// nothing away, what is black by its nature; beyond the eye ray's hit also lamps behind a surface.
    bool saysNothing(int node) const;

private:
    /// `alone`: no factor stands beside it, so that a sum needs no parentheses.
    template <class Leaf>
    std::string expression(int node, bool alone, const Leaf& leaf) const;
};

/// A line of the ledger as it is read: below a node its operands, the parentheses between them left out.
struct LedgerLine {
    int node = 0;
    bool factor = false; // of a product; else an addend of a sum
};
std::vector<LedgerLine> linesBelow(const Ledger&, int node);

}
