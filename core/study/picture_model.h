#pragma once
// What a picture is made with, as far as it can be made smaller, and the ways to do so.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/scene/camera.h"
#include "core/scene/world.h"
#include "core/transport/settings.h"

namespace eyeray {

struct PictureModel {
    std::shared_ptr<const Scene> scene;
    Camera camera;
    TraceSettings trace;
    AccelKind accel = AccelKind::Auto;
    int samples = 1; // per pixel
};

/// The index that finds the hits of its picture.
AccelKind indexOf(const PictureModel&);

/// One thing of a model that could be smaller: by how much, smallest first.
struct NeedLadder {
    struct Rung {
        std::string to;
        std::function<void(PictureModel&)> climb; // makes a model that much smaller
    };
    std::string what, from; // "max depth", "16"
    std::vector<Rung> rungs;
    std::string leftOut;     // what a rung leaves out, plural, with {} for its `to`
    bool evenIfFree = false; // worth having if it changes no pixel, though it saves no ray
};

/// A rung that no pixel can tell from what is set, by proof from the scene alone.
struct ProvedNeed {
    NeedLadder ladder;  // of one rung; of none where the renderer alone leaves something out
    std::string to;     // what the rung, or the renderer, brings it to
    std::string reason; // one line
    std::function<void(SceneNeeds&)> force; // has the renderer do it all the same; may be empty
};

/// What the model does not need, by reading its scene.
std::vector<ProvedNeed> provedNeeds(const PictureModel&);

/// What could be left out of the model, by subject; each subject sees the model that the one before has left.
struct NeedSubject {
    std::string name;
    std::vector<NeedLadder> (*ladders)(const PictureModel&);
};
const std::vector<NeedSubject>& needSubjects();

/// The material with its factors alone.
void dropTextures(MaterialModel&);

}
