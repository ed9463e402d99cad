#pragma once

#include "core/pipeline/registry.h"

#include <vector>

namespace espalier {

// The methods of each step, which registry.cpp lists. The first of each is the default.

[[nodiscard]] std::vector<Method> cropMethods();      // crop_methods.cpp
[[nodiscard]] std::vector<Method> valueMethods();     // crop_methods.cpp
[[nodiscard]] std::vector<Method> groundMethods();    // surroundings_methods.cpp
[[nodiscard]] std::vector<Method> poleMethods();      // surroundings_methods.cpp
[[nodiscard]] std::vector<Method> wireMethods();      // surroundings_methods.cpp
[[nodiscard]] std::vector<Method> plantMethods();     // surroundings_methods.cpp
[[nodiscard]] std::vector<Method> thinMethods();      // thin_methods.cpp
[[nodiscard]] std::vector<Method> leafMethods();      // organ_methods.cpp
[[nodiscard]] std::vector<Method> bladeMethods();     // organ_methods.cpp
[[nodiscard]] std::vector<Method> cleanMethods();     // clean_methods.cpp
[[nodiscard]] std::vector<Method> smoothMethods();    // smooth_methods.cpp
[[nodiscard]] std::vector<Method> contractMethods();  // contract_methods.cpp
[[nodiscard]] std::vector<Method> skeletonMethods();  // skeleton_methods.cpp
[[nodiscard]] std::vector<Method> joinMethods();      // repair_methods.cpp
[[nodiscard]] std::vector<Method> pruneMethods();     // shape_methods.cpp
[[nodiscard]] std::vector<Method> axesMethods();      // shape_methods.cpp
[[nodiscard]] std::vector<Method> recenterMethods();  // shape_methods.cpp
[[nodiscard]] std::vector<Method> insertionMethods(); // repair_methods.cpp
[[nodiscard]] std::vector<Method> endsMethods();      // shape_methods.cpp
[[nodiscard]] std::vector<Method> nodeMethods();      // repair_methods.cpp
[[nodiscard]] std::vector<Method> radiusMethods();    // radius_methods.cpp

// Contractions by equations, along paths, and by sampling: surface_contract_methods.cpp.
[[nodiscard]] std::vector<Method> surfaceContractMethods();

// Skeletons by a simpler tree of shortest paths over the points: path_methods.cpp.
[[nodiscard]] Method shortestPathMethod();
[[nodiscard]] Method branchStructureMethod();

// Skeletons that grow into the points, from the root: colonization_methods.cpp.
[[nodiscard]] Method graphColonizationMethod();
[[nodiscard]] Method pointTrackingMethod();
[[nodiscard]] Method spaceColonizationMethod();

} // namespace espalier
