#include "app/cli/options.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/cli/chart_lists.h"
#include "app/document/scene_files.h"
#include "core/base/errors.h"
#include "core/render/render_settings.h"
#include "core/study/picture_errors.h"

namespace eyeray {
namespace {

constexpr int kMostSamples = 1 << 24;

/// Adds `--key VALUE` that becomes the command `name key=VALUE`.
void addSetting(CLI::App& app, PictureOptions& options, const std::string& key, const std::string& type,
                const std::string& help, const std::string& command = "set") {
    app.add_option_function<std::string>(
           "--" + key,
           [&options, key, command](const std::string& value) {
               options.commands.push_back({command, {{key, value}}});
           },
           help)
        ->type_name(type)
        ->trigger_on_parse();
}

void addSwitchOff(CLI::App& app, PictureOptions& options, const std::string& key) {
    app.add_flag_callback(
        "--no-" + key, [&options, key] { options.commands.push_back({"set", {{key, "off"}}}); },
        fmt::format("no {} rays", key.back() == 's' ? key.substr(0, key.size() - 1) : key));
}

void addStop(CLI::App& app, PictureOptions& options, const std::string& key, const std::string& type,
             const std::string& help) {
    app.add_option_function<std::string>(
           "--" + key,
           [&options, key](const std::string& value) {
               options.commands.push_back({"set", {{key, value}}});
               options.stops = true;
           },
           help)
        ->type_name(type)
        ->trigger_on_parse();
}

/// What traces, not what is shown.
void addMachine(CLI::App& app, PictureOptions& options) {
    addSetting(app, options, "accel", "NAME", "auto, brute, bvh2 or bvh8");
    addSetting(app, options, "threads", "N", "threads that trace; 0 is one per core");
}

void addView(CLI::App& app, PictureOptions& options) {
    const auto side = CLI::Range(1, kMaxPictureSide);
    app.add_option("--width", options.width, "width of the picture in pixels")->check(side)->type_name("N");
    app.add_option("--height", options.height, "height of the picture in pixels")
        ->check(side)
        ->type_name("N");
    addSetting(app, options, "camera", "NAME|INDEX", "one of the scene's cameras", "camera");
    addSetting(app, options, "aspect", "A", "width by height: 16:9, 1.5");
    addSetting(app, options, "fov", "DEG", "vertical field of view");
    addSetting(app, options, "lens", "R", "radius of the lens in metres; 0 is a pinhole");
    addSetting(app, options, "focus", "D", "distance in metres that is sharp; 0 is the target's");
    addSetting(app, options, "exposure", "EV", "brightness shown, in stops");
    addSetting(app, options, "tonemap", "NAME", "none, clamp, reinhard or aces");
}

/// What is traced, but for what `chart` takes lists of.
void addRays(CLI::App& app, PictureOptions& options) {
    for (const char* kind : {"shadows", "reflections", "refractions", "diffuse"})
        addSwitchOff(app, options, kind);
    addSetting(app, options, "fresnel", "NAME", "exact or constant weights at glass");
    addSetting(app, options, "seed", "N", "start of the random numbers");
}

void addPicture(CLI::App& app, PictureOptions& options) {
    addView(app, options);
    addSetting(app, options, "method", "NAME", "local, cast, whitted, distributed or path");
    addSetting(app, options, "max-depth", "D", "deepest rays: 0 is eye rays alone, up to 64");
    addSetting(app, options, "cutoff", "C", "smallest contribution that is traced");
    addRays(app, options);
    addSetting(app, options, "glass-shadows", "NAME", "shadow rays at glass: opaque, straight or all");
    addSetting(app, options, "sampler", "NAME", "independent, stratified or sobol random numbers");
    addStop(app, options, "samples", "N", "stop after N samples per pixel");
    addStop(app, options, "seconds", "S", "stop after S seconds");
    addStop(app, options, "error", "E", "stop when the estimated error (0 to 1) is below E");
    addSetting(app, options, "adaptive", "on|off",
               "with --error: each pixel stops by the error around it (on), or all together");
    app.add_option("--first-pass", options.firstPass, "number of the first sample")
        ->check(CLI::Range(0, kMostSamples))
        ->type_name("K");
    addMachine(app, options);
    addSetting(app, options, "fault", "NAME[,NAME]", "well-known mistakes to show, such as moller-trumbore");
    addSetting(app, options, "epsilon", "E", "what the fault global-epsilon skips of a ray");
    addSetting(app, options, "clamp", "L", "radiance that the fault early-clamp cuts off at");
    addSetting(app, options, "precision", "NAME", "float or double formulas of faults");
    addSetting(app, options, "aim", "NAME", "what eye rays go through: samples, or edges of meshes");
}

void addChart(CLI::App& app, ChartOptions& options) {
    app.add_option("-o,--output", options.output, "folder to write to; made if it is not there")
        ->required()
        ->type_name("DIR");
    for (const ChartList& list : kChartLists)
        app.add_option(fmt::format("--{}", list.key), options.lists[std::string(list.key)],
                       std::string(list.help))
            ->type_name("A,B,…");
    app.add_option("--repeats", options.repeats, "runs of each, with other random numbers")
        ->check(CLI::Range(1, 99))
        ->type_name("N");
    app.add_option("--reference-samples", options.referenceSamples,
                   "of the pictures taken as right; else 16 times the most samples")
        ->check(CLI::Range(2, kMostSamples))
        ->type_name("N");
    app.add_option("--limit", options.limitSeconds, "seconds of tracing after which a point has failed")
        ->check(CLI::Range(0.001, 1e6))
        ->type_name("S");
    app.add_option("--error", options.adaptiveError,
                   "of displayed values (0 to 1), that adaptive sampling aims at; 0.002")
        ->check(CLI::Range(1e-6, 1.0))
        ->type_name("E");
    app.add_option("--metric", options.metric,
                   "error that is drawn: rmse, relmse, p95, shown-rmse, shown-p95, flip")
        ->check(CLI::IsMember(std::vector<std::string>(kErrorMetricNames.begin(), kErrorMetricNames.end())))
        ->type_name("NAME");
    app.add_flag("--quiet", options.quiet, "no progress line");
    addView(app, options.picture);
    addRays(app, options.picture);
    addSetting(app, options.picture, "fault", "NAME[,NAME]", "well-known mistakes to chart");
    addSetting(app, options.picture, "threads", "N", "threads that trace; 0 is one per core");
}

/// `--apply` and the name of a file go together.
void addNeeds(CLI::App& app, NeedsOptions& options) {
    app.add_option("--tolerance", options.tolerance,
                   "share of the displayed range, 0 to 1: no pixel may change by more, nor mean FLIP; else "
                   "1/255")
        ->check(CLI::Range(0.0, 1.0))
        ->type_name("T");
    app.add_flag("--json", options.json, "the items as one JSON object");
    app.add_flag("--quiet", options.quiet, "no progress line");
    CLI::Option* const file =
        app.add_option("-o,--output", options.output, "the scene with the smaller settings")
            ->type_name("FILE.gltf");
    CLI::Option* const apply =
        app.add_flag("--apply", options.apply, "check at full size, and write the scene with what it needs");
    apply->needs(file);
    file->needs(apply);
    addPicture(app, options.picture);
}

void addScene(CLI::App& app, PictureOptions& options, bool required) {
    app.add_option("scene", options.scene, "built-in scene, .gltf or .glb file, or a picture made by Eyeray")
        ->required(required)
        ->type_name("SCENE");
}

void setWindowSize(SnapshotOptions& options, const std::string& text) {
    constexpr double kSmallest = 320, kLargest = 8192;
    const std::size_t x = std::min(text.find('x'), text.size());
    const double width = toNumber(text.substr(0, x)).value_or(0);
    const double height = toNumber(text.substr(std::min(x + 1, text.size()))).value_or(0);
    const auto fits = [&](double side) { return side >= kSmallest && side <= kLargest; };
    if (!fits(width) || !fits(height))
        throw InputError("--size " + text, "not a window size",
                         "give WxH such as 1280x720, each from 320 to 8192");
    options.windowWidth = static_cast<int>(width);
    options.windowHeight = static_cast<int>(height);
}

/// X,Y of whole numbers; that they lie in the picture is checked when its size is known.
PixelPosition pixelFrom(const std::string& text) {
    const Command command("--pixel", {{"x", text.substr(0, std::min(text.find(','), text.size()))},
                                      {"y", text.substr(std::min(text.find(','), text.size() - 1) + 1)}});
    try {
        return {*command.integer("x", 0, kMaxPictureSide), *command.integer("y", 0, kMaxPictureSide)};
    } catch (const InputError&) {
        throw InputError("--pixel " + text, "not a pixel",
                         "give X,Y such as 320,240, from 0,0 at the top left");
    }
}

/// CLI11's own messages span several lines and name no remedy.
[[noreturn]] void refuse(const CLI::ParseError& error) {
    std::string what = error.what();
    what = what.substr(0, what.find('\n'));
    throw InputError("command line", what, "see `eyeray --help`");
}

}

std::variant<Options, int> parseCommandLine(int argc, const char* const* argv) {
    CLI::App app("Eyeray: an interactive teaching viewer with progressive ray tracing");
    app.name("eyeray");
    app.set_version_flag("--version", fmt::format("eyeray {}", EYERAY_VERSION));
    app.require_subcommand(0, 1);
    app.footer("Without a subcommand it opens the viewer: eyeray [SCENE]");

    ViewOptions view;
    RenderOptions render;
    SnapshotOptions snapshot;
    InspectOptions inspect;
    HitsOptions hits;
    BenchOptions bench;
    StabilityOptions stability;
    CompareOptions compare;
    ChartOptions chart;
    NeedsOptions needs;
    NameBugOptions nameBug;
    std::string size, play, stats, layer, widgets, pixel, inspected, accel, difference;

    CLI::App* viewing = app.add_subcommand("view", "open the viewer");
    addScene(*viewing, view.picture, false);
    addPicture(*viewing, view.picture);
    viewing->add_option("--widgets", widgets, "for tests: write where each widget stands, at each frame")
        ->type_name("FILE");

    CLI::App* rendering = app.add_subcommand("render", "render a picture to .png .exr .hdr .pfm .ppm");
    addScene(*rendering, render.picture, true);
    rendering->add_option("-o,--output", render.output, "file to write")->required()->type_name("FILE");
    addPicture(*rendering, render.picture);
    rendering
        ->add_option(
            "--layer", layer,
            "color, normal, depth, albedo, id, rays, recursion, visits, tests, cost, error, samples, "
            "a ray kind, lamp.NAME, rest; or all, in one .exr")
        ->type_name("NAME");
    rendering->add_option("--stats", stats, "write figures as JSON")->type_name("FILE");
    rendering->add_flag("--quiet", render.quiet, "no progress line");

    CLI::App* drawing = app.add_subcommand("snapshot", "draw the whole viewer window without a display");
    addScene(*drawing, snapshot.picture, true);
    drawing->add_option("-o,--output", snapshot.output, "file to write")->required()->type_name("FILE.png");
    drawing->add_option("--size", size, "size of the window")->type_name("WxH");
    drawing->add_option("--play", play, "file of commands to carry out first")->type_name("FILE");
    addPicture(*drawing, snapshot.picture);

    CLI::App* inspecting = app.add_subcommand("inspect", "the rays of one sample of a pixel, and their sum");
    addScene(*inspecting, inspect.picture, true);
    inspecting->add_option("--pixel", pixel, "which pixel; 0,0 is at the top left")
        ->required()
        ->type_name("X,Y");
    inspecting->add_option("--sample", inspect.sample, "which of its samples; 0 goes through its centre")
        ->check(CLI::Range(0, kMostSamples))
        ->type_name("K");
    inspecting->add_option("--format", inspect.format, "text, json, csv or svg")
        ->transform(CLI::Transformer(std::map<std::string, InspectFormat>{{"text", InspectFormat::Text},
                                                                          {"json", InspectFormat::Json},
                                                                          {"csv", InspectFormat::Csv},
                                                                          {"svg", InspectFormat::Svg}}))
        ->type_name("NAME");
    inspecting
        ->add_option_function<std::string>(
            "--least-weight",
            [&inspect](const std::string& value) {
                const Command command("inspect", {{"least-weight", value}});
                inspect.leastWeight = static_cast<float>(*command.number("least-weight", 0, 1));
            },
            "svg: leave out rays that weigh less than this")
        ->type_name("W");
    inspecting->add_option("-o,--output", inspected, "file to write; else standard output")
        ->type_name("FILE");
    addPicture(*inspecting, inspect.picture);

    CLI::App* hitting = app.add_subcommand("hits", "what rays hit: one a line in, one answer a line out");
    addScene(*hitting, hits.picture, true);
    hitting->footer(
        "Standard input: ox oy oz dx dy dz [tmin tmax] a line, in the scene's coordinates; t is in "
        "units of the direction.\nStandard output: miss, or t id nx ny nz.");
    CLI::Option* any = hitting->add_flag_callback(
        "--any", [&hits] { hits.question = HitQuestion::Any; }, "only whether anything is hit: 1 or 0");
    hitting
        ->add_flag_callback(
            "--spawn", [&hits] { hits.question = HitQuestion::Spawned; },
            "whether the mirrored and the refracted ray (index 1.5) meet their own surface: 1, 0 or -")
        ->excludes(any);
    addMachine(*hitting, hits.picture);

    CLI::App* timing = app.add_subcommand("bench", "rays a second by index and kind of ray");
    timing->add_option("scene", bench.scene, "scene or mesh; without one, homage and knot")
        ->type_name("SCENE|MESH");
    timing->add_flag("--json", bench.json, "a list of objects, one for each line of figures");
    timing->add_option("--seconds", bench.seconds, "about how long to measure")
        ->check(CLI::Range(0.1, 3600.0))
        ->type_name("S");
    timing->add_option("--threads", bench.threads, "only with as many; else 1, 2 and one per core")
        ->check(CLI::Range(1, 256))
        ->type_name("N");
    timing->add_option("--accel", accel, "only brute, bvh2 or bvh8")
        ->check(CLI::IsMember({"brute", "bvh2", "bvh8"}))
        ->type_name("NAME");

    CLI::App* charting =
        app.add_subcommand("chart", "speed against accuracy: points.csv, chart.svg, report.html");
    addScene(*charting, chart.picture, true);
    addChart(*charting, chart);

    CLI::App* needing = app.add_subcommand("needs", "what a scene needs and what it does not");
    addScene(*needing, needs.picture, true);
    addNeeds(*needing, needs);

    CLI::App* failing = app.add_subcommand(
        "stability", "where methods fail: naive formulas against the renderer's, measured");
    failing->add_option("-o,--output", stability.folder, "folder for report.html and cases.csv")
        ->required()
        ->type_name("DIR");
    failing->add_flag("--json", stability.json, "all figures as one JSON list in place of the table");
    failing->add_option("--rays", stability.rays, "rays, or what stands for them, of each form at each value")
        ->check(CLI::Range(1000, 5'000'000))
        ->type_name("N");

    CLI::App* comparing = app.add_subcommand("compare", "the difference between two pictures of one size");
    comparing->add_option("a", compare.reference, "the picture that is right")->required()->type_name("A");
    comparing->add_option("b", compare.test, "the picture to be judged")->required()->type_name("B");
    comparing->add_option("-o,--output", difference, "draw the difference that is seen, in false colours")
        ->type_name("DIFF.png");
    comparing->add_flag("--json", compare.json, "the figures as one JSON object");

    CLI::App* naming = app.add_subcommand("name-bug", "which known mistake explains a wrong picture");
    addScene(*naming, nameBug.picture, true);
    naming->add_option("picture", nameBug.wrong, "of the same scene, of any size")
        ->required()
        ->type_name("PICTURE");
    naming->add_flag("--json", nameBug.json, "all faults as one JSON object");
    addPicture(*naming, nameBug.picture);

    const CLI::App* listing = app.add_subcommand("scenes", "list the built-in scenes");

    // `eyeray SCENE` is `eyeray view SCENE`
    std::vector<std::string> words(argv + 1, argv + argc);
    const auto subcommands = app.get_subcommands({});
    const bool bare = !words.empty() && words[0].rfind('-', 0) != 0 &&
                      std::none_of(subcommands.begin(), subcommands.end(),
                                   [&](const CLI::App* known) { return known->get_name() == words[0]; });
    if (bare || words.empty()) words.insert(words.begin(), "view");
    std::reverse(words.begin(), words.end());
    try {
        app.parse(words);
    } catch (const CLI::Success& success) {
        return app.exit(success);
    } catch (const CLI::ParseError& error) {
        refuse(error);
    }
    if (!widgets.empty()) view.widgets = widgets;
    if (!layer.empty()) render.layer = layer;
    if (!stats.empty()) render.stats = stats;
    if (!play.empty()) snapshot.play = play;
    if (!size.empty()) setWindowSize(snapshot, size);
    if (!pixel.empty()) inspect.pixel = pixelFrom(pixel);
    if (!inspected.empty()) inspect.output = inspected;
    if (!difference.empty()) compare.output = difference;
    if (!accel.empty())
        bench.accel = static_cast<AccelKind>(std::ranges::find(kAccelNames, accel) - kAccelNames.begin());
    if (rendering->parsed()) return Options(render);
    if (drawing->parsed()) return Options(snapshot);
    if (inspecting->parsed()) return Options(inspect);
    if (hitting->parsed()) return Options(hits);
    if (timing->parsed()) return Options(bench);
    if (failing->parsed()) return Options(stability);
    if (comparing->parsed()) return Options(compare);
    if (charting->parsed()) return Options(chart);
    if (needing->parsed()) return Options(needs);
    if (naming->parsed()) return Options(nameBug);
    if (listing->parsed()) return Options(ScenesOptions{});
    if (view.picture.scene.empty()) view.picture.scene = kDefaultScene;
    return Options(view);
}

}
