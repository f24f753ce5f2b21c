#pragma once
// One function per subcommand. Each returns the exit code or throws InputError (2) or Failure (1).

#include "app/cli/options.h"
#include "app/document/scene_files.h"

namespace eyeray {

int run(const ViewOptions&);
int run(const RenderOptions&);
int run(const SnapshotOptions&);
int run(const InspectOptions&);
int run(const HitsOptions&);
int run(const BenchOptions&);
int run(const StabilityOptions&);
int run(const CompareOptions&);
int run(const ChartOptions&);
int run(const NeedsOptions&);
int run(const NameBugOptions&);
int run(const ScenesOptions&);

/// Says before the work what would go wrong after it: throws InputError for a name that ends in no picture
/// format, Failure if its folder is not there.
void checkOutput(const std::filesystem::path& output);
/// Only the latter.
void checkFolder(const std::filesystem::path& output);
/// Makes the folder of a report if it is not there. Throws InputError if the name is a file's, Failure if its
/// own folder is not there or cannot be written.
void makeFolder(const std::filesystem::path& folder);

/// The options' scene, opened, with its options applied. Metering is left to the caller.
OpenedScene openFor(const PictureOptions&);

/// Width and height of the picture: as asked for, else by the aspect (0: the default one).
void setSize(RenderSettings&, const PictureOptions&, double aspect);

}
