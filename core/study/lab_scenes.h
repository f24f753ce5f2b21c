#pragma once
// The scenes of the failure lab by the value of their sliders.

#include "core/scene/scene.h"

namespace eyeray::lab {

Scene distantSphere(double distance); // metres to the eye, zoomed to the same size
Scene plateOnFloor(double epsilon);   // does not depend on it
Scene scaledBalls(double scale);      // the same picture at any scale
Scene closedBall(double rows);        // of triangles; seen from inside, by rays aimed at its edges
Scene smallKnot(double size);         // metres; of a fine mesh
Scene coplanarQuads(double degrees);  // of their common tilt
Scene farAway(double metres);         // from the origin of the scene
Scene pancake(double squash);         // thickness of a ball
Scene insideGlass(double degrees);    // angle at which the middle of the picture meets the wall
Scene smoothBall(double segments);    // of a mesh with smooth normals
Scene mirrorTunnel(double depth);     // does not depend on it
Scene faintRays(double cutoff);       // does not depend on it
Scene whiteRoom(double albedo);       // of all walls
Scene caustic(double clamp);          // does not depend on it
Scene softShadow(double samples);     // per pixel
Scene checkerPlain(double samples);   // per pixel

}
