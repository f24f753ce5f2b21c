#pragma once
// One function per subcommand. Each returns the exit code or throws InputError (2) or Failure (1).

#include "app/cli/options.h"
#include "app/document/scene_files.h"

namespace eyeray {

int run(const ViewOptions&);
int run(const RenderOptions&);
int run(const SnapshotOptions&);
int run(const ScenesOptions&);

/// The options' scene, opened, with its options applied. Metering is left to the caller.
OpenedScene openFor(const PictureOptions&);

}
