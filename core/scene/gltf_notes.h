#pragma once
// What an import tells the user, gathered while it reads.

#include <map>
#include <string>

#include "core/scene/gltf.h"

namespace eyeray {

/// Writes an ImportReport that stays readable: features that are left out are counted and told once, and a
/// file with thousands of faults gets a last line that says how many more there are.
class GltfNotes {
public:
    explicit GltfNotes(ImportReport& report) : report_(report) {}

    void added(const std::string& text) { write(ImportReport::Kind::Added, text); }
    void repaired(const std::string& text) { write(ImportReport::Kind::Repaired, text); }
    void doubtful(const std::string& text) { write(ImportReport::Kind::Doubtful, text); }
    void ignored(const std::string& text) { write(ImportReport::Kind::Ignored, text); }

    /// Counts one more of `owner` whose `feature` is left out, such as ("normalTexture", "material").
    void ignoredOne(const std::string& feature, const std::string& owner) { ++counts_[{feature, owner}]; }

    /// Writes the counted features, "normalTexture of 12 materials", and how many lines were too many.
    void finish();

private:
    void write(ImportReport::Kind, const std::string& text);

    ImportReport& report_;
    std::map<std::pair<std::string, std::string>, int> counts_;
    std::size_t dropped_ = 0;
};

/// `value` moved into [lo, hi], with a note that says so if it was not there; `lo` if it is not a number.
double clamped(double value, double lo, double hi, const std::string& what, GltfNotes&);

}
