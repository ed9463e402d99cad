#pragma once

#include "core/base/progress.h"
#include "core/base/shown_message.h"
#include "core/evaluate/light/light_interception.h"
#include "core/evaluate/traits/traits.h"
#include "core/evaluate/traits/wood_amounts.h"
#include "core/graph/find_root.h"
#include "core/skeleton/skeleton.h"

#include <optional>
#include <string>
#include <vector>

namespace espalier {

/// How heavy the wood is. Nobody knows it but the user.
struct WoodDensity {
  double perCubicMeter = 0; // dry mass [kg / m^3]; 0: not known
  double meters = 0;        // in the unit of length; 0: not known

  [[nodiscard]] bool isKnown() const { return perCubicMeter > 0 && meters > 0; }
  /// Of so much wood [kg]. pre: isKnown()
  [[nodiscard]] double biomass(const WoodAmount& wood) const {
    return wood.volume * meters * meters * meters * perCubicMeter;
  }
};

struct PlantMeasureOptions {
  UpAxis up = UpAxis::z;             // that the plant stands along
  double breastHeight = 0;           // [L], as breastHeightIn(); 0: no diameter is measured there
  std::optional<LightOptions> light; // none: it is not measured
  WoodDensity density = {};          // for its biomass
};

/// What is measured on one plant by itself: no reference is needed.
struct PlantMeasures {
  Traits traits;
  WoodAmounts wood;
  std::optional<VolumeInterval> volume;   // of the whole wood; none: too much is unknown
  double volumeUnknown = 0;               // as volumeOfUnknownError()
  std::vector<double> radiusLimits;       // of the classes of `wood` [L]
  WoodDensity density;                    // as asked
  std::optional<double> stemDiameter;     // at breast height [L]; none: see below
  std::string stemMissing;                // why there is none; empty: there is one
  std::optional<LightInterception> light; // none if not asked for, or if no node has a radius
  std::vector<ShownMessage> warnings;     // a line each: what makes the numbers doubtful
};

/// Measures one plant, as compare() measures each of two.
///
/// @throws Error     if it has no nodes, no length, or a position that is no number
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Cost: see the parts; light takes nearly all of it.
[[nodiscard]] PlantMeasures plantMeasures(const Skeleton& plant,
                                          const PlantMeasureOptions& options = {},
                                          const Progress& progress = {});

/// Light on the surface of a plant, as generalized cylinders; none if no node has a radius.
/// @throws Cancelled if `progress` asks to stop
[[nodiscard]] std::optional<LightInterception>
lightOn(const Skeleton& plant, const LightOptions& options, const Progress& progress = {});

/// The plant turned so that it stands along z, about the origin.
[[nodiscard]] Skeleton standing(const Skeleton& plant, UpAxis up);

} // namespace espalier
