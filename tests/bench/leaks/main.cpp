// eyeray_leaks_bench [MILLIONS] [MILLIONS]: how many of a hundred million rays aimed at the edges and
// vertices of closed meshes get out, and how many of ten million that leave a surface meet it again; or of
// other numbers.

#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <cstdlib>

#include "tests/leaks.h"

namespace eyeray {
namespace {

constexpr int kPart = 100'000; // rays of one task

double secondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::int64_t leaksOf(const leaks::ClosedMesh& closed, int parts, ThreadPool& pool) {
    const auto start = std::chrono::steady_clock::now();
    const auto geometry = leaks::indexed<Bvh8>(closed);
    std::atomic<std::int64_t> count = 0;
    pool.forEach(parts, {}, [&](int part) {
        count += leaks::leaksOf(closed, geometry, kPart, static_cast<std::uint32_t>(part) + 1000);
    });
    fmt::print("{:<44}{:>14}{:>8}{:>9.1f} s\n", closed.name, static_cast<std::int64_t>(parts) * kPart,
               count.load(), secondsSince(start));
    std::fflush(stdout);
    return count;
}

std::int64_t selfHits(double millions, ThreadPool& pool) {
    constexpr int kRaysEach = 2000, kRaysOfPart = kRaysEach * 13 * 8; // decades and objects
    const int parts = std::max(1, static_cast<int>(millions * 1e6 / kRaysOfPart));
    const auto start = std::chrono::steady_clock::now();
    std::atomic<std::int64_t> rays = 0, back = 0;
    pool.forEach(parts, {}, [&](int part) {
        const auto spawned = leaks::spawnAtAllScales(kRaysEach, static_cast<std::uint32_t>(part) * 100 + 7);
        rays += spawned.rays;
        back += spawned.back;
    });
    fmt::print("{:<44}{:>14}{:>8}{:>9.1f} s\n", "leaving surfaces of 1e-6 to 1e6 m", rays.load(), back.load(),
               secondsSince(start));
    return back;
}

}
}

int main(int argc, char** argv) {
    const double aimed = argc > 1 ? std::atof(argv[1]) : 100, leaving = argc > 2 ? std::atof(argv[2]) : 10;
    eyeray::ThreadPool pool;
    const auto meshes = eyeray::leaks::closedMeshes();
    const int parts =
        std::max(1, static_cast<int>(aimed * 1e6 / eyeray::kPart / static_cast<double>(meshes.size())));
    fmt::print("{:<44}{:>14}{:>8}{:>11}\n", "", "rays", "wrong", "time");
    std::int64_t wrong = 0;
    for (const auto& closed : meshes) wrong += eyeray::leaksOf(closed, parts, pool);
    wrong += eyeray::selfHits(leaving, pool);
    return wrong == 0 ? 0 : 1;
}
