#include "core/io/plantgl/bgeom_scene.h"

#include "core/base/text.h"
#include "core/io/bytes/byte_reader.h"
#include "core/io/plantgl/bgeom_layout.h"

#include <array>
#include <cmath>
#include <map>
#include <optional>

namespace espalier {
namespace {

constexpr int newestVersion = 25; // 2.5
constexpr std::string_view magic = "!bGEOM";

class BgeomReader {
public:
  BgeomReader(std::string_view bytes, const std::string& file, const Progress& progress)
      : in_(bytes, file), size_(bytes.size()), progress_(progress) {}

  PointScene read() {
    readHeader();
    readTypes();
    (void)in_.value<std::uint32_t>(); // objects in the scene: all that follow are read
    while (!in_.isAtEnd())
      (void)readObject(0);
    return std::move(scene_);
  }

private:
  void readHeader();
  void readTypes();
  std::uint32_t readObject(int depth);
  std::uint32_t readShape(int depth);
  std::uint32_t readReference();
  SceneObject readPoints();
  SceneObject readPlaced(bool isScale, int depth);
  SceneObject readTurned(const std::string& type, int depth);
  SceneObject readGroup(int depth);
  SceneObject skip(const std::string& type, int depth);
  void skipField(char type, SceneObject& object, int depth);
  void skipArray(std::uint64_t size) { (void)in_.take(in_.value<std::uint32_t>() * size); }
  void addPart(SceneObject& object, int depth) { object.parts.push_back(readObject(depth + 1)); }

  [[noreturn]] void failOfDepth() const {
    in_.fail({espalier::Shown::tr("objects are nested deeper than %1: the file is damaged"),
              {std::to_string(PointScene::deepest)}});
  }
  [[nodiscard]] std::string versionText() const {
    return std::to_string(version_ / 10) + "." + std::to_string(version_ % 10);
  }
  double real() { return isDouble_ ? in_.value<double>() : in_.value<float>(); }
  [[nodiscard]] std::uint64_t realSize() const { return isDouble_ ? 8 : 4; }
  Eigen::Vector3d vector() {
    Eigen::Vector3d result;
    for (double& x : result)
      x = real();
    return result;
  }
  std::string text() { return std::string(in_.take(in_.value<std::uint16_t>())); }

  ByteReader in_;
  std::size_t size_;
  const Progress& progress_;
  PointScene scene_;
  std::array<std::string, 256> types_;            // by code
  std::map<std::uint32_t, std::uint32_t> shared_; // objects by ident
  int version_ = 0;                               // 2.3 as 23
  bool isDouble_ = false;
};

void BgeomReader::readHeader() {
  if (in_.left() < magic.size() || in_.take(magic.size()) != magic)
    in_.failAt(
        0, {espalier::Shown::tr("is no binary scene of PlantGL, it does not begin with !bGEOM")});
  const auto version = in_.value<float>();
  if (!(version >= 0.5F && version < 100))
    in_.fail({espalier::Shown::tr("is no version of PlantGL's scenes: the file is damaged")});
  version_ = static_cast<int>(std::lround(version * 10));
  if (version_ > newestVersion)
    in_.fail({espalier::Shown::tr("is version %1 of PlantGL's scenes, and up to 2.5 can be read: "
                                  "export the points as PLY"),
              {versionText()}});
  if (version_ >= 11 && in_.take(2) != "\r\n")
    in_.fail({espalier::Shown::tr(
        "its line end was changed, as a transfer as text does: copy the file again as binary")});
  if (version_ >= 16) {
    const auto bits = in_.value<std::uint8_t>();
    if (bits != 32 && bits != 64)
      in_.fail(
          {espalier::Shown::tr("has reals of %1 bits, expected 32 or 64"), {std::to_string(bits)}});
    isDouble_ = bits == 64;
  }
  if (in_.take(1) != "#")
    in_.fail({espalier::Shown::tr("expected a comment behind #: the file is damaged")});
  (void)in_.takeUntil('#');
}

void BgeomReader::readTypes() {
  types_[1] = "Reference";
  types_[2] = "Shape";
  types_[3] = "Material";
  types_[20] = "Group";
  types_[25] = "PointSet";
  types_[32] = "Translated";
  if (in_.take(1) != "!")
    in_.fail({espalier::Shown::tr("expected the table of types behind !: the file is damaged")});
  for (auto left = in_.value<std::uint32_t>(); left > 0; --left) {
    const auto code = in_.value<std::uint8_t>();
    types_[code] = text();
    (void)in_.value<std::uint32_t>(); // how many there are
  }
  if (in_.take(1) != "!")
    in_.fail({espalier::Shown::tr("expected the scene behind !: the file is damaged")});
}

std::uint32_t BgeomReader::readObject(int depth) {
  if (depth > PointScene::deepest) failOfDepth();
  if (scene_.objects.size() % 1024 == 0)
    progress_.update(static_cast<double>(in_.offset()) / static_cast<double>(size_));
  const std::size_t start = in_.offset();
  const std::string& type = types_[in_.value<std::uint8_t>()];
  if (type.empty())
    in_.failAt(start, {espalier::Shown::tr("an object is of no type known: the file is damaged")});
  if (type == "Shape") return readShape(depth);
  if (type == "Reference") return readReference();
  const std::string name = text();
  const bool hasIdent = version_ >= 20 || !name.empty();
  const std::uint32_t ident = hasIdent ? in_.value<std::uint32_t>() : 0;
  SceneObject object;
  if (type == "PointSet")
    object = readPoints();
  else if (type == "Translated" || type == "Scaled")
    object = readPlaced(type == "Scaled", depth);
  else if (type == "AxisRotated" || type == "EulerRotated" || type == "Oriented")
    object = readTurned(type, depth);
  else if (type == "Group")
    object = readGroup(depth);
  else
    object = skip(type, depth);
  const std::uint32_t place = scene_.add(std::move(object));
  if (scene_.objects[place].height > PointScene::deepest) failOfDepth(); // by references, that is
  if (ident != 0) shared_[ident] = place;
  return place;
}

std::uint32_t BgeomReader::readShape(int depth) {
  (void)text();
  (void)in_.value<std::uint32_t>();
  if (version_ >= 19) (void)in_.value<std::uint32_t>();
  const std::uint32_t geometry = readObject(depth + 1);
  (void)readObject(depth + 1); // its appearance
  scene_.shapes.push_back(geometry);
  return geometry;
}

std::uint32_t BgeomReader::readReference() {
  const std::size_t start = in_.offset();
  const auto found = shared_.find(in_.value<std::uint32_t>());
  if (found == shared_.end())
    in_.failAt(start, {espalier::Shown::tr(
                          "refers to an object that does not come before: the file is damaged")});
  return found->second;
}

SceneObject BgeomReader::readPoints() {
  SceneObject object;
  object.firstPoint = scene_.points.positions.size();
  object.pointCount = in_.value<std::uint32_t>();
  const std::string_view bytes = in_.take(object.pointCount * 3 * realSize());
  const ScalarType type = isDouble_ ? ScalarType::float64 : ScalarType::float32;
  for (std::size_t i = 0; i < 3 * object.pointCount; i += 3) {
    if (i % (3 * 65536) == 0)
      progress_.update(static_cast<double>(in_.offset()) / static_cast<double>(size_));
    const char* at = bytes.data() + i * realSize();
    scene_.points.positions.emplace_back(scalarAt(at, type), scalarAt(at + realSize(), type),
                                         scalarAt(at + 2 * realSize(), type));
  }
  scene_.points.colors.resize(scene_.points.positions.size(), unpainted);
  if (version_ >= 17) {
    const std::uint64_t count = in_.value<std::uint32_t>();
    const std::string_view rgba = in_.take(count * 4);
    const bool fits = count == object.pointCount;
    if (count > 0 && !fits) ++scene_.badColors;
    scene_.hasColors = scene_.hasColors || (fits && count > 0);
    for (std::size_t i = 0; fits && i < count; ++i)
      for (std::size_t channel = 0; channel < 3; ++channel)
        scene_.points.colors[object.firstPoint + i][channel] =
            static_cast<std::uint8_t>(rgba[4 * i + channel]);
  }
  if (version_ >= 21) (void)in_.value<std::uint8_t>(); // width of the points on screen
  return object;
}

SceneObject BgeomReader::readPlaced(bool isScale, int depth) {
  SceneObject object;
  if (isScale)
    object.linear = vector().asDiagonal();
  else
    object.offset = vector();
  addPart(object, depth);
  return object;
}

SceneObject BgeomReader::readTurned(const std::string& type, int depth) {
  const auto mask = in_.value<std::uint8_t>(); // a set bit: the default, and absent
  const auto vectorOr = [&](int bit, const Eigen::Vector3d& usual) {
    return (mask >> bit & 1) != 0 ? usual : vector();
  };
  const auto angle = [&](int bit) { return (mask >> bit & 1) != 0 ? 0.0 : real(); };
  std::optional<Eigen::Matrix3d> turn;
  if (type == "AxisRotated") {
    const Eigen::Vector3d axis = vectorOr(0, Eigen::Vector3d::UnitZ());
    turn = turnedAbout(axis, angle(1));
  } else if (type == "EulerRotated") {
    const double azimuth = angle(0);
    const double elevation = angle(1);
    turn = turnedByEuler(azimuth, elevation, angle(2));
  } else {
    const Eigen::Vector3d primary = vectorOr(0, Eigen::Vector3d::UnitX());
    turn = turnedTo(primary, vectorOr(1, Eigen::Vector3d::UnitY()));
  }
  SceneObject object;
  addPart(object, depth);
  if (turn)
    object.linear = *turn;
  else
    scene_.leaveOutParts(object, size_);
  return object;
}

SceneObject BgeomReader::readGroup(int depth) {
  SceneObject object;
  const bool hasSkeleton = (in_.value<std::uint8_t>() & 1) == 0; // a set bit: the default, none
  if (hasSkeleton) (void)readObject(depth + 1);
  for (auto left = in_.value<std::uint32_t>(); left > 0; --left)
    addPart(object, depth);
  return object;
}

/// Passes over an object that is no point set. Its parts are read, but lead to no points.
SceneObject BgeomReader::skip(const std::string& type, int depth) {
  const auto layout = bgeomLayoutOf(type, version_);
  if (!layout)
    in_.fail({espalier::Shown::tr("has an object %1 whose size is not known in version %2: export "
                                  "the points alone, or as PLY"),
              {inQuotes(type), versionText()}});
  if (layout->isShape) scene_.skipped.insert(type);
  unsigned mask = 0;
  if (layout->maskBytes == 1) mask = in_.value<std::uint8_t>();
  if (layout->maskBytes == 2) mask = in_.value<std::uint16_t>();
  SceneObject object;
  std::string_view rest = layout->fields;
  while (!rest.empty()) {
    std::string_view field = nextWord(rest);
    if (field.size() > 1 && field[1] == ':') {
      const int bit = field[0] >= 'a' ? field[0] - 'a' + 10 : field[0] - '0';
      if ((mask >> bit & 1) != 0) continue;
      field.remove_prefix(2);
    }
    const bool isLater = field.size() == 4; // "b@21"
    if (isLater && version_ < 10 * (field[2] - '0') + (field[3] - '0')) continue;
    skipField(field[0], object, depth);
  }
  scene_.leaveOutParts(object, size_);
  return object;
}

void BgeomReader::skipField(char type, SceneObject& object, int depth) {
  const auto rows = [&] { return std::uint64_t{in_.value<std::uint32_t>()}; };
  switch (type) {
  case 'b':
    return (void)in_.take(1);
  case 'c':
    return (void)in_.take(3);
  case 'u':
    return (void)in_.take(4);
  case 's':
    return (void)text();
  case 'r':
    return (void)in_.take(realSize());
  case 'd':
    return (void)in_.take(2 * realSize());
  case 'v':
    return (void)in_.take(3 * realSize());
  case 'w':
    return (void)in_.take(4 * realSize());
  case 'R':
    return skipArray(realSize());
  case 'D':
    return skipArray(2 * realSize());
  case 'V':
    return skipArray(3 * realSize());
  case 'W':
    return skipArray(4 * realSize());
  case 'C':
    return skipArray(4);
  case 'T':
    return skipArray(12);
  case 'Q':
    return skipArray(16);
  case 'X':
    for (std::uint64_t left = rows(); left > 0; --left)
      skipArray(4);
    return;
  case 'm':
  case 'M': {
    const std::uint64_t height = rows();
    const std::uint64_t count = height * rows(); // below 2^64
    const std::uint64_t size = type == 'm' ? realSize() : 4 * realSize();
    if (count > in_.left() / size)
      in_.fail({espalier::Shown::tr("ends within a matrix: the file is cut short")});
    return (void)in_.take(count * size);
  }
  case 'O':
    for (std::uint64_t left = rows(); left > 0; --left)
      addPart(object, depth);
    return;
  default: // 'o'
    return addPart(object, depth);
  }
}

} // namespace

PointScene bgeomSceneIn(std::string_view bytes, const std::string& file, const Progress& progress) {
  return BgeomReader(bytes, file, progress).read();
}

} // namespace espalier
