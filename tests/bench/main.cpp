// eyeray_bench [coarse|cancel|frames|pick|pictures|start|spheres]…: the figures of tests/bench/README.md; all
// without arguments.

#include <fmt/format.h>
#include <stdlib.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>
#include <fstream>
#include <span>
#include <string>

#include "tests/bench/bench.h"

namespace {

struct Benchmark {
    std::string_view name;
    void (*run)();
};

constexpr std::array kBenchmarks = {
    Benchmark{"coarse", eyeray::bench::benchCoarse},     Benchmark{"cancel", eyeray::bench::benchCancel},
    Benchmark{"frames", eyeray::bench::benchFrames},     Benchmark{"pick", eyeray::bench::benchPick},
    Benchmark{"pictures", eyeray::bench::benchPictures}, Benchmark{"start", eyeray::bench::benchStart},
    Benchmark{"spheres", eyeray::bench::benchSpheres},
};

std::string processor() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);)
        if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
    return "unknown processor";
}

void printMachine() {
    double load = 0;
    if (getloadavg(&load, 1) != 1) load = -1;
    const unsigned cores = std::thread::hardware_concurrency();
    fmt::print("{}, {} cores; load average at the start {:.1f}{}\n", processor(), cores, load,
               load > 0.5 * cores ? ": THE MACHINE IS BUSY, times are too long" : "");
}

}

int main(int argc, char** argv) {
    const std::span arguments(argv + 1, static_cast<std::size_t>(argc - 1));
    const auto asked = [&](std::string_view name) {
        return std::any_of(arguments.begin(), arguments.end(), [&](const char* a) { return name == a; });
    };
    for (const std::string_view argument : arguments)
        if (std::none_of(kBenchmarks.begin(), kBenchmarks.end(),
                         [&](const Benchmark& b) { return b.name == argument; })) {
            fmt::print(stderr, "usage: eyeray_bench [coarse|cancel|frames|pick|pictures|start|spheres]…\n");
            return 2;
        }
    try {
        printMachine();
        for (const Benchmark& benchmark : kBenchmarks)
            if (arguments.empty() || asked(benchmark.name)) benchmark.run();
    } catch (const std::exception& error) {
        fmt::print(stderr, "eyeray_bench: {}\n", error.what());
        return 1;
    }
    return 0;
}
