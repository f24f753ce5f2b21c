#pragma once
// The rays of a tile traced as streams: all of one depth together, sorted by what they hit, several at once.
// R. Wald, G. P. Gribble, S. Boulos, A. Kensler 2007, "SIMD Ray Stream Tracing", University of Utah
// UUSCI-2007-012.

#include "core/transport/integrator.h"

namespace eyeray {

/// Traces sample `pass` of a tile's pixels by the methods local, cast or whitted: the same bits as one ray
/// after the other. Returns nothing if a tree outgrew kMaxTreeNodes; which of its rays are cut then depends
/// on the order.
std::optional<TileResult> renderByStreams(const TraceContext&, const Tile&, int pass);

}
