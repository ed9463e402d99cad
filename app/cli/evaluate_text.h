#pragma once

#include "core/evaluate/comparison.h"
#include "core/evaluate/study/ranking.h"

#include <string>
#include <vector>

namespace espalier {

// What `evaluate` prints on standard output. `unit` names the lengths; empty: it is not known.

void print(const Comparison& comparison, const EditOptions& edit, const std::string& unit);

/// By order, height and radius.
void printWhere(const Comparison& comparison, const std::string& unit);

/// Sizes, Strahler numbers, angles and crown of both, and by how much the result differs.
void printTraits(const Comparison& comparison, const std::string& unit);

/// STAR of both, at rising numbers of pixels; of what has any.
void printLight(const Comparison& comparison);

/// The best first; `names` are what the results are called.
void print(const Ranking& ranking, const std::vector<std::string>& names, const std::string& unit);

} // namespace espalier
