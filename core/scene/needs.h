#pragma once
// What a scene can need at all: the rest is never modelled or traced.

#include <string>
#include <vector>

#include "core/scene/scene.h"

namespace eyeray {

/// What the methods that keep to physics can need: their sky is a lamp, rough surfaces reflect, and matte
/// ones light each other. Refractions and textures are as in SceneNeeds.
struct PhysicalNeeds {
    bool shadows = false;             // something shines, and there is an object
    bool reflections = false;         // some visible material has a coat, is metal or a dielectric
    bool diffuse = false;             // some visible material is matte
    std::vector<std::string> reasons; // as in SceneNeeds
};

/// What can change a pixel. Every `false` is proved from the scene alone, and `reasons` says why.
struct SceneNeeds {
    bool shadows = false;     // some lamp shines and something can block it
    bool reflections = false; // some visible material reflects or is a dielectric
    bool refractions = false; // some visible material transmits
    bool textures = false;    // some visible material reads a texture or vertex colours
    std::vector<std::string>
        reasons; // one line for each thing left out: "no refraction rays: nothing transmits light"
    PhysicalNeeds physical;
};

SceneNeeds analyseNeeds(const Scene&);

/// What a material can do at some point of it, whatever its textures hold.
struct MaterialNeeds {
    bool reflects = false, transmits = false; // transmission brings a reflection of its own
    bool textured = false;
    bool reflectsPhysically = false, diffuses = false; // as PhysicalSurface
    bool glows = false;
};

MaterialNeeds needsOf(const MaterialModel&);

}
