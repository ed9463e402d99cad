#pragma once

#include "core/pipeline/contract_probes.h"
#include "core/pipeline/method_parts.h"

#include <utility>

namespace espalier {

/// The method `described`, with the options of `table`, whose work is `contract(points, options,
/// state, progress)`: the new places of the points that cleaning kept, from where they are by now;
/// those at the place of one go with it, the others stay. It is taken to see no root.
/// `probe(options)` is how it looks at the plant.
template <class Options, class Contract, class Probe>
[[nodiscard]] Method contractMethod(Method described, const OptionTable<Options>& table,
                                    const Contract& contract, const Probe& probe) {
  described.options = table.descriptions();
  described.seesRoot = false;
  described.probe = [table, probe](const Values& values) { return probe(table.with(values)); };
  described.run = [table, contract](PipelineState& state, const Values& values,
                                    const Progress& progress) {
    const std::vector<Eigen::Index> kept = keptPoints(state);
    requirePlant(kept);
    Eigen::Matrix3Xf positions = *state.contracted;
    const Eigen::Matrix3Xf points = positions(Eigen::all, kept);
    positions(Eigen::all, kept) = contract(points, table.with(values), state, progress);
    followKept(positions, state);
    state.contracted = std::make_shared<const Eigen::Matrix3Xf>(std::move(positions));
  };
  return described;
}

} // namespace espalier
