#pragma once

#include "core/mtg/mtg.h"
#include "core/skeleton/skeleton.h"

#include <iosfwd>

namespace espalier {

/// Writes a whole MTG as text: all classes, rules, features, vertices, aliases and dates.
///
/// A line per vertex, laid out as `mtgRows` says, then a line "*" per later date; columns are
/// parted by tabs, those of features are adjacent. Numbers of type REAL and INT lose their
/// exponents, which OpenAlea takes for edges, and keep their value; other values are written as
/// they are. A feature Alias is added if vertices have aliases and none is declared. OpenAlea,
/// PlantScan3D and MultiScaleTreeGraph.jl read the result, but for what `openAleaLimits` lists.
/// Reading the text gives `mtgAsWritten(mtg)`; writing that again gives the same bytes.
/// @throws Error if something cannot be written in MTG text: a value with a tab, a line end or a
///         comment sign, a symbol whose class is not listed, labels that look like others, a
///         vertex as stated at `mtgRows`. Nothing is written then: the text is read back before
/// Time O(size of the text).
void writeMtg(std::ostream& out, const Mtg& mtg);

/// With what writing changes or adds: numbers without exponents, no empty values at the end, a
/// feature Alias. The vertices keep their order.
[[nodiscard]] Mtg mtgNormalized(Mtg mtg);

/// An MTG as it comes back from its text: vertices in the order of their lines, numbers without
/// exponents, no empty values at the end.
[[nodiscard]] Mtg mtgAsWritten(const Mtg& mtg);

/// Writes mtgOf(skeleton), by default as PlantScan3D does: a plant P of scale 1 per root, its
/// nodes N of scale 2, features XX YY ZZ radius.
///
/// A branching node opens the next column, a successor continues its own ("^<N"); of two successors
/// the second opens a column too. Deeper than 64 columns, which no plant is, a node continues its
/// column with the child that carries most ("^+N"). Numbers are the
/// shortest decimals that read back as the same double, without exponents; a radius of 0 is left
/// empty. OpenAlea, PlantScan3D and MultiScaleTreeGraph.jl read the result.
/// @throws Error if a position or radius is not finite
void writeMtg(std::ostream& out, const Skeleton& skeleton);

} // namespace espalier
