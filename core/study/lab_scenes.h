#pragma once
// The scenes of the failure lab by the value of their sliders.

#include "core/scene/scene.h"

namespace eyeray::lab {

Scene distantSphere(double distance); // metres to the eye, zoomed to the same size
Scene plateOnFloor(double epsilon);   // does not depend on it
Scene scaledBalls(double scale);      // the same picture at any scale
Scene smallKnot(double size);         // metres; of a fine mesh
Scene coplanarQuads(double degrees);  // of their common tilt
Scene farAway(double metres);         // from the origin of the scene
Scene pancake(double squash);         // thickness of a ball
Scene insideGlass(double degrees);    // angle at which the middle of the picture meets the wall
Scene smoothBall(double segments);    // of a mesh with smooth normals
Scene mirrorTunnel(double depth);     // does not depend on it
Scene caustic(double radius);         // of a lamp of the same power
Scene softShadow(double samples);     // per pixel
Scene checkerPlain(double samples);   // per pixel

}
