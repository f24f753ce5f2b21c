#pragma once
// A document as a scene that can be written to a file.

#include "app/document/document.h"

namespace eyeray {

/// The edited scene with the document's camera as its first one and its settings as the scene's own; when to
/// stop and on how many threads is left out.
Scene savedScene(const Document&);

}
