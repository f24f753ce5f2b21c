#pragma once
// The pixel ledger: the colour of one sample as the sum that the tracer itself added up.

#include <span>
#include <string_view>
#include <vector>

#include "core/transport/integrator.h"

namespace eyeray {

/// What a node of the ledger stands for.
enum class Term : std::uint8_t {
    Radiance,      // what a ray brings: T · […], or […] where no medium is on the way
    Arriving,      // […]: emission + ambient + each lamp's term + what is mirrored and refracted
    Emission,      // Le
    Ambient,       // ka Ia
    Lamp,          // (kd term + ks term) · irradiance · visibility
    Local,         // kd term + ks term
    Diffuse,       // kd (n·l)
    Specular,      // ks (r·v)^n or ks (n·h)^n
    Irradiance,    // of the lamp over π at normal incidence: the lectures' colour of a lamp
    Visibility,    // of the lamp
    Onward,        // kr·[…] + kt·[…]
    Sent,          // kr·[…], or kt·[…]
    Share,         // kr or kt at this angle
    Transmittance, // T of the medium on the way
    Background     // what the ray sees where it hits nothing
};

/// In one word: "radiance", "lamp", "visibility".
std::string_view name(Term);

/// One node of the expression, with its result in the tracer's own float arithmetic.
struct LedgerNode {
    enum class Operation : std::uint8_t { Value, Sum, Product } operation = Operation::Value;
    Term term = Term::Radiance;
    int ray = -1;  // that it belongs to; of Share and Sent: the ray that is sent on
    int lamp = -1; // index into SampleRecord::lamps of Lamp and what is in it
    int end = 0;   // index after the last node within this one
    Color value{0};
};

/// An expression in pre-order: a node, then its operands in order, each followed by its own.
struct Ledger {
    std::vector<LedgerNode> nodes; // the first is the whole; none if nothing was traced

    const LedgerNode& at(int node) const { return nodes[static_cast<std::size_t>(node)]; }
    std::vector<int> operandsOf(int node) const;
};

/// The ledger of one sample. The result of its first node is the sum of what the record says, computed by the
/// operations of the tracer in the order of the tracer: so it has the bits of Retrace::radiance, unless that
/// is black for the sum not being finite.
Ledger ledgerOf(const SampleRecord&);

/// A node that is given another value: "what if this shadow ray were not blocked?" sets a visibility to 1.
struct Strike {
    int node = 0;
    Color value{0};
    friend bool operator==(const Strike&, const Strike&) = default;
};

/// What the film gets of a ledger, computed anew from its leaves; with strikes, in order of their nodes, what
/// it would get. Black if there is no ledger or the sum is not finite, as in the film.
Color evaluate(const Ledger&, std::span<const Strike> strikes = {});

/// Value of one node under the strikes.
Color valueOf(const Ledger&, int node, std::span<const Strike> strikes);

/// The strike that a person means by taking a node away: a visibility turns about (blocked becomes 1,
/// unblocked 0), a medium lets all through, anything else becomes 0.
Strike strikeOf(const Ledger&, int node);

/// The mean of a pixel's samples in order of their passes, by the operations of Film: has the film's bits.
class PixelMean {
public:
    void add(const Color& sample);
    int samples() const { return samples_; }
    Color value() const; // black for no sample

private:
    DVec3 sum_{0};
    int samples_ = 0;
};

}
