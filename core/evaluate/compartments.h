#pragma once

#include "core/evaluate/plant_measures.h"

#include <optional>
#include <string>
#include <vector>

namespace espalier {

/// Organs of one class, and what there is of them.
struct Compartment {
  /// To people: "0" of an order, "U" of a class; of diameters the least and the greatest say it.
  std::string name;
  std::optional<double> from = {}; // of diameters [L]; none: from 0
  std::optional<double> upTo = {}; // likewise; none: no end
  WoodAmount wood;
  std::optional<double> biomass = {}; // [kg]; none: the density of the wood is not known
};

/// The plant by one kind of class: the parts of each sum up to all of it that has such a class.
struct CompartmentTable {
  enum class Kind { order, diameter, mtgClass };
  Kind kind = Kind::order;
  int scale = 0; // of classes of an MTG
  std::vector<Compartment> rows;
};

/// Length, volume and biomass by order, by diameter where there are radii, and for each scale of an
/// MTG by class.
/// Source: compartments of C. Preuksakarn, thesis, Montpellier 2, 2012, section 2.1.2.
[[nodiscard]] std::vector<CompartmentTable> compartments(const PlantMeasures& measures);

} // namespace espalier
