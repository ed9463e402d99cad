#pragma once

#include "core/surface/envelopes/envelope.h"

namespace espalier {

struct ExtrudedHullOptions {
  bool isAcross = false; // the vertical profile is that seen along the outline's length
};

/// The hull that a horizontal profile sweeps along a vertical one: at each height it is as wide as
/// the vertical profile there, and keeps its form.
///
/// The horizontal profile is the convex outline of the crown from above, the vertical one that from
/// the side: across it the outline is longest, or widest if `isAcross`. Both are drawn through the
/// extreme points; the crown is in it where each of its sections is as its outline.
/// Parameters: azimuth of the plane of the vertical profile, and how many corners each profile has.
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O(corners log corners + mesh) and that of shareInside() for all points.
/// Source: P. Birnbaum, "Modalites d'occupation de l'espace par les arbres en foret guyanaise",
/// thesis, 1997, as in F. Boudon, thesis, 2004, 2.1.
[[nodiscard]] Envelope extrudedHull(const Crown& crown, const ExtrudedHullOptions& options = {},
                                    const Progress& progress = {});

} // namespace espalier
