#pragma once
// A shader program that draws the items of a scene; the ways to shade them differ.

#include "app/gl/program.h"
#include "app/rayview/projection.h"
#include "app/rayview/scene_meshes.h"

namespace eyeray {

/// `shading` is the GLSL of the fragment stage. It may call vec3 viewer() (unit, towards the eye), vec3
/// facingNormal() (unit, on the viewer's side) and vec3 textureColor(), and read `position` (relative to the
/// World's origin).
class ItemProgram {
public:
    ItemProgram(const Gl&, const char* shading);

    /// Makes it current, seen through this projection. Depth is tested and written, nothing is blended.
    void begin(const Projection&);

    /// Draws an item with the uniforms that are set.
    void draw(const SceneItem&);

    void set(const char* name, float value) const { gl_.uniform1f(program_.uniform(name), value); }
    void set(const char* name, int value) const { gl_.uniform1i(program_.uniform(name), value); }
    void set(const char* name, const Vec3& v) const { gl_.uniform3f(program_.uniform(name), v.x, v.y, v.z); }
    void set(const char* name, const std::vector<Vec4>& values) const;

private:
    void setTexture(const ItemTexture&) const;

    const Gl& gl_;
    Program program_;
    DMat4 clip_{1};
};

}
