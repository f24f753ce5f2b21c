#pragma once
// The sum of a path: a flat list of what the lamps bring at its vertices, and what it comes upon.

#include <string>
#include <vector>

#include "core/scene/scene.h"
#include "core/transport/recorder.h"

namespace eyeray {

/// One addend of Kajiya's path sum (1986, "The Rendering Equation"): throughput × f cos / pdf × MIS weight ×
/// radiance × visibility. The MIS weight is of the power heuristic (Veach 1997, section 9.2).
struct PathTerm {
    enum class Source : std::uint8_t {
        DiffuseLight,  // of a lamp, by the diffuse lobe
        SpecularLight, // of a lamp, by the reflection or refraction lobe
        Emission,      // of the surface that a ray comes upon
        Background     // of the sky, where it comes upon nothing
    } source = Source::DiffuseLight;
    int ray = -1;  // at whose end
    int lamp = -1; // index into SampleRecord::lamps, −1 for what is come upon
    Color throughput{
        1};             // of the path to there: each vertex's f cos / pdf / probability, and the media's part
    Color scattered{1}; // f cos towards the lamp, per steradian; 1 for what is come upon
    float pdfW = 0;     // with which the place on the lamp was taken, per steradian; 0: there is but one
    float mis = 1;
    Color radiance{0}; // of the lamp or what is come upon; of a lamp without extent its irradiance
    Color visibility{1};
    Color value{0}; // the product
};

/// The addends of a sample of a physical method, in order of tracing, black ones left out; none for another
/// method. Their sum is the sample's radiance but for rounding.
std::vector<PathTerm> pathTermsOf(const SampleRecord&);

/// Added up in double.
DVec3 sumOf(const std::vector<PathTerm>&);

/// Whence its light comes, in words: "ceiling lamp at red wall #2", "the sky, by ray #3".
std::string wayOf(const Scene&, const SampleRecord&, const PathTerm&);

/// "0.3 · 0.21 / 0.5 · 0.9 · 12": the factors that are not 1.
std::string factorsOf(const PathTerm&);

}
