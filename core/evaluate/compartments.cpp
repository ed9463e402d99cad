#include "core/evaluate/compartments.h"

namespace espalier {

std::vector<CompartmentTable> compartments(const PlantMeasures& measures) {
  const auto make = [&](const std::string& name, const WoodAmount& wood) {
    Compartment made{.name = name, .wood = wood};
    if (measures.density.isKnown()) made.biomass = measures.density.biomass(wood);
    return made;
  };
  const WoodAmounts& wood = measures.wood;
  std::vector<CompartmentTable> tables(1);
  for (std::size_t order = 0; order < wood.byOrder.size(); ++order)
    tables[0].rows.push_back(make(std::to_string(order), wood.byOrder[order]));
  const std::vector<double>& limits = measures.radiusLimits;
  if (!limits.empty()) {
    CompartmentTable& table = tables.emplace_back();
    table.kind = CompartmentTable::Kind::diameter;
    for (std::size_t k = 0; k < wood.byRadius.size(); ++k) {
      table.rows.push_back(make({}, wood.byRadius[k]));
      if (k > 0) table.rows.back().from = 2 * limits[k - 1];
      if (k < limits.size()) table.rows.back().upTo = 2 * limits[k];
    }
  }
  for (const ClassAmount& each : wood.byClass) {
    const bool isNew =
        tables.back().kind != CompartmentTable::Kind::mtgClass || tables.back().scale != each.scale;
    if (isNew) tables.push_back({CompartmentTable::Kind::mtgClass, each.scale, {}});
    tables.back().rows.push_back(make(each.symbol, each.wood));
  }
  return tables;
}

} // namespace espalier
