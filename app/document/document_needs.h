#pragma once
// What a document's picture needs, as a question and as an edit.

#include "app/document/document.h"
#include "core/study/measured_needs.h"

namespace eyeray {

/// The question for a picture of this size. `meterExposure` as in OpenedScene.
NeedsPlan needsPlan(const Document&, int width, int height, bool meterExposure);

/// The document with the smallest model that was found.
Document withNeeded(const Document&, const MeasuredNeeds&);

/// "16 to 7"; "left out", "stays 16".
std::string changeText(const NeedItem&);

/// What an item saves: "12 %", "under 1 %"; of one that is proved, what the renderer saves by itself.
std::string savingText(const NeedItem&);

/// "none", "1/255, FLIP 0.0012".
std::string errorText(const ModelError&);

/// "2.4 times faster, FLIP 0.0031", or that all is needed.
std::string summaryText(const MeasuredNeeds&);

/// Of the index of the picture as set: "bvh8".
std::string_view indexName(const MeasuredNeeds&);

/// Where, with how many samples and by which index, and within what.
std::string measureText(const MeasuredNeeds&);

}
