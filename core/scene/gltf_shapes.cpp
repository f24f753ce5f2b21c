#include "core/scene/gltf_import.h"

namespace eyeray {

namespace {

Box readBox(GltfFields fields) {
    const Color size = fields.color("size", Color(1), kPositive);
    return {size};
}

Cylinder readCylinder(GltfFields fields) {
    const Cylinder defaults;
    Cylinder cylinder;
    cylinder.height = fields.real("height", defaults.height, kPositive);
    cylinder.radiusTop = fields.real("radiusTop", defaults.radiusTop, kNotNegative);
    cylinder.radiusBottom = fields.real("radiusBottom", defaults.radiusBottom, kNotNegative);
    if (cylinder.radiusTop == 0 && cylinder.radiusBottom == 0) fields.refuse("both radii are 0");
    return cylinder;
}

Plane readPlane(GltfFields fields) {
    Plane plane;
    plane.sizeX = fields.real("sizeX", plane.sizeX, kPositive);
    plane.sizeZ = fields.real("sizeZ", plane.sizeZ, kPositive);
    plane.doubleSided = fields.flag("doubleSided", plane.doubleSided);
    return plane;
}

std::optional<Shape> readShape(GltfFields& fields) {
    const std::string type = fields.text("type", "");
    if (type == "sphere") return Sphere{fields.child("sphere").real("radius", Sphere{}.radius, kPositive)};
    if (type == "box") return readBox(fields.child("box"));
    if (type == "cylinder") return readCylinder(fields.child("cylinder"));
    if (type == "plane") return readPlane(fields.child("plane"));
    return std::nullopt;
}

}

std::vector<int> importShapes(GltfImport& context) {
    constexpr const char* kExtension = "KHR_implicit_shapes";
    GltfFields extension =
        extensionFields(context.document.model.extensions, kExtension, context.document.where, context.notes);
    std::vector<int> result;
    for (GltfFields& fields : extension.children("shapes")) {
        const auto shape = readShape(fields);
        if (shape) {
            result.push_back(static_cast<int>(context.scene.shapes.size()));
            context.scene.shapes.push_back(*shape);
        } else {
            result.push_back(-1);
            context.notes.ignored(fields.where() + ": a shape of this type is not shown");
        }
    }
    return result;
}

}
