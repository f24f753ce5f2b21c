// What a picture costs with ten times as many balls each time: in a tree, like the logarithm of their number.

#include <cmath>

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>

#include "core/scene/generate.h"
#include "tests/bench/bench.h"

namespace eyeray::bench {
namespace {

constexpr int kRepetitions = 5;

/// The built-in scene with another number of balls, which cover as much of the picture.
Scene withBalls(const Scene& many, int count) {
    const auto isBall = [](const Object& object) { return object.name.rfind("balls", 0) == 0; };
    Scene scene = many;
    const Object prototype = *std::ranges::find_if(scene.objects, isBall);
    std::erase_if(scene.objects, isBall);
    for (const Ball& ball : makeSpiral({.count = count, .radius = 7.0 / std::sqrt(count), .spread = 9})) {
        Object object = prototype;
        object.transform = glm::scale(glm::translate(DMat4(1), ball.center), DVec3(ball.radius));
        object.material = 1 + ball.turn % 6;
        scene.objects.push_back(object);
    }
    return scene;
}

}

void benchSpheres() {
    Document document = openForever("many");
    document.render.width = kWidth / 2;
    document.render.height = kHeight / 2;
    document.render.stop.samples = 1;
    document.render.coarse = false;
    const Scene many = *document.scene;
    printHeading("Pictures of n balls, 640x360, one sample, one thread", "ms");
    for (int count = 100; count <= 1'000'000; count *= 10) {
        const auto scene = std::make_shared<const Scene>(withBalls(many, count));
        const auto start = Clock::now();
        const auto world = buildWorld(scene, {AccelKind::Bvh8});
        const double built = secondsSince(start) * 1e3;
        RenderSession session(1);
        std::vector<double> times, perRay;
        for (int i = 0; i < kRepetitions; ++i) {
            session.start(world, document.camera, document.render);
            RenderStatus status = session.status();
            while (status.active()) status = session.wait(std::chrono::milliseconds(100));
            times.push_back(status.secondsToFirstPass * 1e3);
            perRay.push_back(status.secondsToFirstPass * 1e9 / static_cast<double>(status.counts.total()));
        }
        printSeries(fmt::format("{} balls, {:.0f} ms to build", count, built), times);
        printSeries("    nanoseconds a ray", perRay);
    }
}

}
