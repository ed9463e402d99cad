#include "core/io/plantgl/bgeom_layout.h"

#include <algorithm>
#include <array>

namespace espalier {
namespace {

constexpr std::string_view mesh3 = "0:b 1:b 2:o V T 4:b 3:V 6:T 7:b 8:C 9:T 5:D a:T";
constexpr std::string_view mesh4 = "0:b 1:b 2:o V Q 4:b 3:V 6:Q 7:b 8:C 9:Q 5:D a:Q";
constexpr std::string_view meshOfAny = "0:b 1:b 2:o V X 4:b 3:V 6:X 7:b 8:C 9:X 5:D a:X";
constexpr int firstMeshVersion = 15; // meshes lay otherwise before

constexpr auto layouts = std::to_array<BgeomLayout>(
    {{"AsymmetricHull", 2, "0:r 1:r 2:r 3:r 4:r 5:r 6:r 7:r 8:v 9:v a:r b:r c:b d:b"},
     {"BezierCurve", 1, "0:u 1:b W"},
     {"BezierCurve2D", 1, "0:u 1:b V"},
     {"BezierPatch", 1, "0:u 1:u 2:b M"},
     {"Box", 1, "0:v"},
     {"Cone", 1, "0:r 1:r 2:b 3:b"},
     {"Cylinder", 1, "0:r 1:r 2:b 3:b"},
     {"Disc", 1, "0:r 1:b"},
     {"ElevationGrid", 1, "0:r 1:r 2:b m"},
     {"ExtrudedHull", 1, "0:b o o"},
     {"Extrusion", 1, "0:b 1:b 2:D 3:R 4:R 5:v@22 o o"},
     {"FaceSet", 2, meshOfAny},
     {"Font", 1, "s 0:u 1:b 2:b", false},
     {"Frustum", 1, "0:r 1:r 2:r 3:b 4:b"},
     {"Material", 1, "0:c 1:r 2:c 3:c 4:r 5:r", false},
     {"MonoSpectral", 1, "0:r 1:r", false},
     {"NurbsCurve", 1, "0:u 1:R 2:u 3:b W"},
     {"NurbsCurve2D", 1, "0:u 1:R 2:u 3:b V"},
     {"NurbsPatch", 1, "0:u 1:u 2:R 3:R 4:u 5:u 6:b M"},
     {"Paraboloid", 1, "0:r 1:r 2:r 3:b 4:b 5:b@16"},
     {"PointSet2D", 0, "D b@21"},
     {"Polyline", 0, "V C@17 b@21"},
     {"Polyline2D", 0, "D b@21"},
     {"QuadSet", 2, mesh4},
     {"Revolution", 1, "0:b o"},
     {"ScreenProjected", 0, "b o"},
     {"Sphere", 1, "0:r 1:b 2:b"},
     {"Swung", 1, "0:b 1:b 2:u 3:u R O"},
     {"Tapered", 1, "0:r 1:r o"},
     {"Text", 1, "s 0:o 1:v@17 2:b@17"},
     {"TriangleSet", 2, mesh3}});

} // namespace

std::optional<BgeomLayout> bgeomLayoutOf(std::string_view type, int version) {
  const auto* found = std::ranges::find(layouts, type, &BgeomLayout::type);
  if (found == layouts.end()) return std::nullopt;
  const bool isMesh =
      found->fields == mesh3 || found->fields == mesh4 || found->fields == meshOfAny;
  if (isMesh && version < firstMeshVersion) return std::nullopt;
  return *found;
}

} // namespace espalier
