#include "core/io/plantgl/geom_scene.h"

#include "core/base/text.h"
#include "core/io/plantgl/geom_text.h"
#include "core/io/plantgl/geom_types.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

namespace espalier {
namespace {

/// What the fields of a moved, scaled or turned object say.
struct Placing {
  std::map<std::string_view, Eigen::Vector3d> vectors = {{"Axis", Eigen::Vector3d::UnitZ()},
                                                         {"Primary", Eigen::Vector3d::UnitX()},
                                                         {"Scale", Eigen::Vector3d::Ones()},
                                                         {"Secondary", Eigen::Vector3d::UnitY()},
                                                         {"Translation", Eigen::Vector3d::Zero()}};
  std::map<std::string_view, double> angles = {
      {"Angle", 0}, {"Azimuth", 0}, {"Elevation", 0}, {"Roll", 0}}; // [degrees]

  /// None if it is not stated how.
  [[nodiscard]] std::optional<Eigen::Matrix3d> linearOf(std::string_view type) const {
    const auto radians = [&](std::string_view name) {
      return angles.at(name) * std::numbers::pi / 180;
    };
    if (type == "AxisRotated") return turnedAbout(vectors.at("Axis"), radians("Angle"));
    if (type == "EulerRotated")
      return turnedByEuler(radians("Azimuth"), radians("Elevation"), radians("Roll"));
    if (type == "Oriented") return turnedTo(vectors.at("Primary"), vectors.at("Secondary"));
    if (type == "Scaled") return vectors.at("Scale").asDiagonal().toDenseMatrix();
    return Eigen::Matrix3d::Identity();
  }
};

class GeomReader {
public:
  GeomReader(std::string_view text, const std::string& file, const Progress& progress)
      : in_(text, file), size_(text.size()), progress_(progress) {}

  PointScene read();

private:
  void readCommand();
  std::uint32_t readObject(int depth);
  SceneObject readBody(std::string_view type, int depth);
  SceneObject readPoints(int depth);
  void readColors(std::size_t firstPoint);
  SceneObject readPlaced(std::string_view type, int depth);
  SceneObject readGroup(int depth);
  SceneObject readShape(int depth);
  SceneObject skipBody(std::string_view type, int depth);
  void readPart(SceneObject& object, int depth);
  template <class Item> void readList(const Item& item);
  void skipValue(int depth);
  void skipBrackets();

  /// "Sphere {" or "Sphere name {"
  [[nodiscard]] bool isObjectNext() const {
    return in_.next().isWord() &&
           (in_.next(1).is('{') || (in_.next(1).isWord() && in_.next(2).is('{')));
  }
  /// The next field of an object; none at its end.
  std::optional<std::string_view> nextField() {
    if (in_.takeIf('}')) return std::nullopt;
    return in_.takeWord(
        espalier::Shown::tr("expected a field or }, found %1: export the points as PLY or .bgeom"));
  }
  void updateProgress() const {
    progress_.update(static_cast<double>(in_.offset()) / static_cast<double>(size_));
  }

  GeomText in_;
  std::size_t size_;
  const Progress& progress_;
  PointScene scene_;
  std::map<std::string_view, std::uint32_t> named_; // places of objects
  std::set<std::uint32_t> contained_;               // places of objects that others refer to
  int passedOver_ = 0;                              // objects around that are passed over
};

PointScene GeomReader::read() {
  std::vector<std::uint32_t> outermost;
  while (!in_.isAtEnd()) {
    if (in_.next().kind == GeomToken::Kind::command)
      readCommand();
    else
      outermost.push_back(readObject(0));
  }
  if (scene_.shapes.empty())
    std::ranges::copy_if(outermost, std::back_inserter(scene_.shapes),
                         [&](std::uint32_t object) { return !contained_.contains(object); });
  return std::move(scene_);
}

void GeomReader::readCommand() {
  const GeomToken command = in_.next();
  const std::string name = lowerCase(command.text);
  if (name != "echo" && name != "list" && name != "quit")
    in_.failAt(command.line,
               {espalier::Shown::tr("':%1' is not read: open the scene in PlantGL and save it as "
                                    "one file, or export the points as PLY"),
                {std::string(command.text)}});
  in_.skipLine();
}

std::uint32_t GeomReader::readObject(int depth) {
  const std::size_t line = in_.next().line;
  const auto checkDepth = [&](int levels) {
    if (levels > PointScene::deepest)
      in_.failAt(
          line, {espalier::Shown::tr("objects are nested deeper than %1: export the points as PLY"),
                 {std::to_string(PointScene::deepest)}});
  };
  checkDepth(depth);
  if (scene_.objects.size() % 1024 == 0) updateProgress();
  if (!isGeometry(in_.next().text) && !isAppearance(in_.next().text))
    in_.failOfNext(espalier::Shown::tr(
        "expected an object, as PointSet { }, found %1: export the points as PLY or .bgeom"));
  const std::string_view type = in_.take().text;
  const std::string_view name = in_.next().isWord() ? in_.take().text : std::string_view();
  in_.require('{');
  const std::uint32_t place = scene_.add(readBody(type, depth));
  checkDepth(scene_.objects[place].height); // through references, that is
  if (type == "Shape" && passedOver_ == 0) scene_.shapes.push_back(place);
  if (!name.empty() && type != "Shape") named_[name] = place;
  return place;
}

SceneObject GeomReader::readBody(std::string_view type, int depth) {
  if (type == "PointSet") return readPoints(depth);
  if (type == "Group") return readGroup(depth);
  if (type == "Shape") return readShape(depth);
  if (isPlacing(type)) return readPlaced(type, depth);
  return skipBody(type, depth);
}

SceneObject GeomReader::readPoints(int depth) {
  SceneObject object;
  std::vector<Eigen::Vector3d>& positions = scene_.points.positions;
  object.firstPoint = positions.size();
  std::vector<Color> colors;
  while (const auto field = nextField()) {
    if (*field == "PointList")
      readList([&] { positions.push_back(in_.takeVector()); });
    else if (*field == "ColorList")
      readList([&] { colors.push_back(in_.takeColor()); });
    else
      skipValue(depth);
  }
  object.pointCount = positions.size() - object.firstPoint;
  const bool fits = colors.size() == object.pointCount;
  if (!colors.empty() && !fits) ++scene_.badColors;
  scene_.hasColors = scene_.hasColors || (fits && !colors.empty());
  if (!fits) colors.assign(object.pointCount, unpainted);
  scene_.points.colors.insert(scene_.points.colors.end(), colors.begin(), colors.end());
  return object;
}

SceneObject GeomReader::readPlaced(std::string_view type, int depth) {
  SceneObject object;
  Placing placing;
  while (const auto field = nextField()) {
    if (*field == "Geometry")
      readPart(object, depth);
    else if (const auto vector = placing.vectors.find(*field); vector != placing.vectors.end())
      vector->second = in_.takeVector();
    else if (const auto angle = placing.angles.find(*field); angle != placing.angles.end())
      angle->second = in_.takeNumber();
    else
      skipValue(depth);
  }
  if (type == "Translated") object.offset = placing.vectors.at("Translation");
  if (const auto linear = placing.linearOf(type))
    object.linear = *linear;
  else
    scene_.leaveOutParts(object, size_);
  return object;
}

SceneObject GeomReader::readGroup(int depth) {
  SceneObject object;
  while (const auto field = nextField()) {
    if (*field == "GeometryList")
      readList([&] { readPart(object, depth); });
    else
      skipValue(depth);
  }
  return object;
}

/// Its fields may come without their names: "Shape { geometry, appearance }".
SceneObject GeomReader::readShape(int depth) {
  SceneObject object;
  if (in_.next().isWord() && (in_.next(1).is('}') || in_.next(1).is(','))) {
    readPart(object, depth);
    if (in_.takeIf(',')) skipValue(depth);
    in_.require('}');
    return object;
  }
  while (const auto field = nextField()) {
    if (*field == "Geometry")
      readPart(object, depth);
    else
      skipValue(depth);
  }
  return object;
}

/// Passes over an object that is no point set. Its parts are read, but lead to no points.
SceneObject GeomReader::skipBody(std::string_view type, int depth) {
  SceneObject object;
  std::vector<std::uint32_t> inner;
  ++passedOver_;
  for (int open = 1; open > 0;) {
    if (in_.isAtEnd()) in_.failOfEnd();
    if (isObjectNext() && isGeometry(in_.next().text)) {
      inner.push_back(readObject(depth + 1));
      continue;
    }
    const GeomToken token = in_.take();
    if (token.is('{')) ++open;
    if (token.is('}')) --open;
    const auto named = token.isWord() ? named_.find(token.text) : named_.end();
    if (named == named_.end()) continue;
    object.parts.push_back(named->second);
    contained_.insert(named->second);
  }
  --passedOver_;
  std::ranges::copy_if(inner, std::back_inserter(object.parts), [&](std::uint32_t part) {
    return !contained_.contains(part); // by another of them
  });
  if (isOtherGeometry(type)) scene_.skipped.emplace(type);
  scene_.leaveOutParts(object, size_);
  return object;
}

void GeomReader::readPart(SceneObject& object, int depth) {
  if (isObjectNext()) {
    object.parts.push_back(readObject(depth + 1));
    return;
  }
  const std::size_t line = in_.next().line;
  const std::string_view name = in_.takeWord(espalier::Shown::tr(
      "expected an object or its name, found %1: export the points as PLY or .bgeom"));
  const auto found = named_.find(name);
  if (found == named_.end())
    in_.failAt(
        line, {espalier::Shown::tr(
                   "refers to %1, which does not come before: the file is damaged or not complete"),
               {inQuotes(name)}});
  object.parts.push_back(found->second);
  contained_.insert(found->second);
}

/// "[a, b, ...]"
template <class Item> void GeomReader::readList(const Item& item) {
  in_.require('[');
  if (in_.takeIf(']')) return;
  std::size_t count = 0;
  do {
    if (++count % 65536 == 0) updateProgress();
    item();
  } while (in_.takeIf(','));
  in_.require(']');
}

/// Passes over the value of a field that leads to no points: an object, a name, a number, a list.
void GeomReader::skipValue(int depth) {
  if (isObjectNext()) {
    ++passedOver_;
    (void)readObject(depth + 1);
    --passedOver_;
  } else if (in_.next().is('<') || in_.next().is('[')) {
    skipBrackets();
  } else if (in_.next().is('-') || in_.next().is('+') ||
             in_.next().kind == GeomToken::Kind::number) {
    (void)in_.takeNumber();
  } else if (in_.next().isWord() || in_.next().kind == GeomToken::Kind::quoted) {
    (void)in_.take();
  } else {
    in_.failOfNext(
        espalier::Shown::tr("expected a value, found %1: export the points as PLY or .bgeom"));
  }
}

void GeomReader::skipBrackets() {
  std::size_t open = 0;
  do {
    if (in_.isAtEnd()) in_.failOfEnd();
    const GeomToken token = in_.take();
    if (token.is('<') || token.is('[')) ++open;
    if (token.is('>') || token.is(']')) --open;
  } while (open > 0);
}

} // namespace

PointScene geomSceneIn(std::string_view text, const std::string& file, const Progress& progress) {
  return GeomReader(text, file, progress).read();
}

} // namespace espalier
