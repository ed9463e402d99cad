#pragma once

#include "core/base/imported.h"
#include "core/base/progress.h"
#include "core/cloud/point_cloud.h"

#include <iosfwd>
#include <string>

namespace espalier {

/// Points of a text scene of PlantGL (.geom): the point sets of all its shapes, moved, scaled and
/// turned as the scene says, groups and named objects included. A scene without shapes is one of
/// all its objects that no other contains.
///
/// A set without colors is white if another has some. What is no point set is passed over with a
/// note; so are points that the scene bends. Formulas, macros and included files are not read.
///
/// @param file  its name, for messages
/// @throws Error     naming the line, if it breaks the grammar, is cut short, includes other files
///                   or defines macros, names an object that does not come before, nests objects
///                   deeper than 64, or repeats shared points more than 16 times
/// @throws Cancelled if `progress` asks to stop
/// Time and memory O(size of the file). No unit is stated.
/// Source: PlantGL's grammar (scne_scanner, scne_parser); angles are in degrees.
[[nodiscard]] Imported<RawPoints> readGeom(std::istream& in, const std::string& file,
                                           const Progress& progress = {});

} // namespace espalier
