#include "core/io/plantgl/geom_types.h"

#include <set>

namespace espalier {
namespace {

using Names = std::set<std::string_view>;

} // namespace

bool isOtherGeometry(std::string_view type) {
  static const Names types = {"AmapSymbol",    "AsymmetricHull", "BezierCurve",
                              "BezierCurve2D", "BezierPatch",    "Box",
                              "Cone",          "Cylinder",       "Disc",
                              "ElevationGrid", "ExtrudedHull",   "Extrusion",
                              "FaceSet",       "Frustum",        "IFS",
                              "Inline",        "NurbsCurve",     "NurbsCurve2D",
                              "NurbsPatch",    "Paraboloid",     "PointSet2D",
                              "Polyline",      "Polyline2D",     "QuadSet",
                              "Revolution",    "Sphere",         "ScreenProjected",
                              "Swung",         "Tapered",        "Text",
                              "TriangleSet"};
  return types.contains(type);
}

bool isPlacing(std::string_view type) {
  static const Names types = {"AxisRotated", "EulerRotated", "Oriented", "Scaled", "Translated"};
  return types.contains(type);
}

bool isAppearance(std::string_view type) {
  static const Names types = {
      "Font",      "ImageTexture",           "Material", "MonoSpectral", "MultiSpectral",
      "Texture2D", "Texture2DTransformation"};
  return types.contains(type);
}

bool isGeometry(std::string_view type) {
  return isOtherGeometry(type) || isPlacing(type) || type == "Group" || type == "PointSet" ||
         type == "Shape";
}

} // namespace espalier
