#include "core/project/node_bytes.h"

#include "core/base/coordinates.h"
#include "core/base/shown_message.h"
#include "core/project/content_hash.h"
#include "core/project/history.h"
#include "core/skeleton/finite_node.h"

#include <algorithm>
#include <bit>
#include <concepts>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace espalier {
namespace {

/// 6 has organs of points, 5 origins of radii, 4 indices that are texts; where there are none, the
/// version before is written, which older programs read. 2 had no points, 1 no reviews either; else
/// all are the same.
constexpr std::uint8_t bytesVersion = 6;
constexpr std::uint8_t versionOfOrigins = 5;
constexpr std::uint8_t versionOfTextIndices = 4;
constexpr std::uint8_t leastVersion = 3; // that is written
constexpr std::size_t hashSize = 8;

enum NodeFlag : std::uint8_t {
  hasParent = 1,
  isBranching = 2,
  hasEntities = 4,
  isMarked = 8,
  hasReview = 16,
  hasOrigin = 32
};
enum ChangeFlag : std::uint8_t { hasBefore = 1, hasAfter = 2 };

/// Of an entity; whether values of it are followed by the types of their features.
/// An index that is more than a number is a text.
enum EntityFlag : std::uint8_t { hasIndex = 1, hasTypes = 2, hasIndexText = 4 };

bool isTyped(const Entity& entity) {
  const auto has = [](const std::vector<FeatureValue>& values) {
    return std::ranges::any_of(values, [](const FeatureValue& each) { return !each.type.empty(); });
  };
  return has(entity.values) || std::ranges::any_of(entity.later, has);
}

/// Whether a node that is read is no damage.
bool isReadable(const Node& node) {
  return isFinite(node) && isInRange(node.position, node.radius) && node.origin.isSound();
}

/// What a reader takes for damage is not written.
/// @throws Error if a reader would refuse the node, or its id
void requireSound(NodeId id, const Node& node) {
  const std::string number = std::to_string(indexOf(id));
  if (!isReadable(node))
    throw ShownError({espalier::Shown::tr("node %1 has a position or radius that is not finite or "
                                          "too large, which a project cannot keep: undo what made "
                                          "it"),
                      {number}});
  if (indexOf(id) >= mostIds || (node.parent && indexOf(*node.parent) >= mostIds))
    throw ShownError({espalier::Shown::tr("node %1 has a number too large for a project: start a "
                                          "new project with the plant"),
                      {number}});
}

std::uint8_t indexFlag(const Entity& entity) {
  if (!entity.index) return 0;
  return entity.index->isPlain() ? hasIndex : hasIndexText;
}

/// What is not as it should be; caught where reading begins.
struct Malformed {};

class Writer {
public:
  Writer() { number(leastVersion); }

  template <std::unsigned_integral Number> void number(Number value) {
    for (std::size_t i = 0; i < sizeof(Number); ++i)
      bytes_.push_back(static_cast<char>((std::uint64_t{value} >> (8 * i)) & 0xFF));
  }
  void size(std::size_t value) { number(static_cast<std::uint32_t>(value)); }
  void real(double value) { number(std::bit_cast<std::uint64_t>(value)); }
  void id(NodeId id) { number(static_cast<std::uint32_t>(id)); }
  void text(const std::string& text) {
    size(text.size());
    bytes_ += text;
  }
  void values(const std::vector<FeatureValue>& values, bool withTypes) {
    size(values.size());
    for (const FeatureValue& value : values) {
      text(value.feature);
      text(value.text);
      if (withTypes) text(value.type);
    }
  }
  void entity(const Entity& entity) {
    number(static_cast<std::uint32_t>(entity.scale));
    text(entity.symbol);
    const bool withTypes = isTyped(entity);
    number(static_cast<std::uint8_t>(indexFlag(entity) | (withTypes ? hasTypes : 0)));
    if (indexFlag(entity) == hasIndex) number(static_cast<std::uint32_t>(entity.index->number()));
    if (indexFlag(entity) == hasIndexText) {
      needs(versionOfTextIndices);
      text(entity.index->text());
    }
    text(entity.alias);
    values(entity.values, withTypes);
    size(entity.later.size());
    for (const std::vector<FeatureValue>& date : entity.later)
      values(date, withTypes);
  }
  /// @throws Error if it could not be read back
  void node(NodeId id, const Node& node) {
    requireSound(id, node);
    number(static_cast<std::uint8_t>(
        (node.parent ? hasParent : 0) | (node.edge == EdgeType::branching ? isBranching : 0) |
        (node.entities.empty() ? 0 : hasEntities) | (node.isMarked ? isMarked : 0) |
        (node.review == ReviewMark() ? 0 : hasReview) |
        (node.origin == RadiusOrigin() ? 0 : hasOrigin)));
    for (int i = 0; i < 3; ++i)
      real(node.position[i]);
    real(node.radius);
    if (node.parent) this->id(*node.parent);
    if (!node.entities.empty()) size(node.entities.size());
    for (const Entity& one : node.entities)
      entity(one);
    if (node.review != ReviewMark()) review(node.review);
    if (node.origin != RadiusOrigin()) origin(node.origin);
  }

  void points(const PointSet& points) {
    size(points.runs().size());
    for (const PointSet::Run& run : points.runs()) {
      number(run.begin);
      number(run.end);
    }
  }

  void organs(const OrganMarks& organs) {
    if (organs.isEmpty()) return;
    needs(bytesVersion);
    for (const PointSet& set : organs.sets())
      points(set);
  }

  [[nodiscard]] std::string finished() {
    number(contentHash(bytes_));
    return std::move(bytes_);
  }

private:
  void needs(std::uint8_t version) {
    bytes_.front() =
        static_cast<char>(std::max(static_cast<std::uint8_t>(bytes_.front()), version));
  }
  void review(const ReviewMark& review) {
    number(static_cast<std::uint8_t>(review.state));
    text(review.comment);
    text(review.reviewer);
  }
  void origin(const RadiusOrigin& origin) {
    needs(versionOfOrigins);
    number(static_cast<std::uint8_t>(origin.source));
    number(std::bit_cast<std::uint32_t>(origin.least));
    number(std::bit_cast<std::uint32_t>(origin.most));
  }

  std::string bytes_;
};

class Reader {
public:
  explicit Reader(std::string_view bytes) {
    if (bytes.size() < 1 + hashSize) throw Malformed{};
    rest_ = bytes.substr(bytes.size() - hashSize);
    const auto hash = number<std::uint64_t>();
    rest_ = bytes.substr(0, bytes.size() - hashSize);
    if (hash != contentHash(rest_)) throw Malformed{};
    written_ = number<std::uint8_t>();
    if (written_ < 1 || written_ > bytesVersion) throw Malformed{};
  }

  template <std::unsigned_integral Number> Number number() {
    if (rest_.size() < sizeof(Number)) throw Malformed{};
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < sizeof(Number); ++i)
      value |= std::uint64_t{static_cast<unsigned char>(rest_[i])} << (8 * i);
    rest_.remove_prefix(sizeof(Number));
    return static_cast<Number>(value);
  }
  /// A count of things that take at least `bytesEach`: a file cannot ask for more than it holds.
  std::size_t count(std::size_t bytesEach) {
    const std::size_t value = number<std::uint32_t>();
    if (value > rest_.size() / bytesEach) throw Malformed{};
    return value;
  }
  double real() { return std::bit_cast<double>(number<std::uint64_t>()); }
  NodeId id() {
    const auto value = number<std::uint32_t>();
    if (value >= mostIds) throw Malformed{};
    return NodeId{value};
  }
  int integer() { return std::bit_cast<std::int32_t>(number<std::uint32_t>()); }
  std::string text() {
    const std::size_t size = count(1);
    std::string result(rest_.substr(0, size));
    rest_.remove_prefix(size);
    return result;
  }
  std::vector<FeatureValue> values(bool withTypes) {
    std::vector<FeatureValue> result;
    for (std::size_t left = count(8); left > 0; --left) {
      FeatureValue value;
      value.feature = text();
      value.text = text();
      if (withTypes) value.type = text();
      result.push_back(std::move(value));
    }
    return result;
  }
  Entity entity() {
    Entity result;
    result.scale = integer();
    result.symbol = text();
    const auto flags = number<std::uint8_t>();
    if ((flags & hasIndex) != 0) result.index = integer();
    if ((flags & hasIndexText) != 0) {
      result.index = LabelIndex::in(text());
      if (!result.index) throw Malformed{};
    }
    result.alias = text();
    const bool withTypes = (flags & hasTypes) != 0;
    result.values = values(withTypes);
    for (std::size_t left = count(4); left > 0; --left)
      result.later.push_back(values(withTypes));
    return result;
  }
  Node node() {
    Node result;
    const auto flags = number<std::uint8_t>();
    for (int i = 0; i < 3; ++i)
      result.position[i] = real();
    result.radius = real();
    if (!isReadable(result)) throw Malformed{};
    result.isMarked = (flags & isMarked) != 0;
    if ((flags & hasParent) != 0) result.parent = id();
    if ((flags & isBranching) != 0) result.edge = EdgeType::branching;
    if ((flags & hasEntities) != 0)
      for (std::size_t left = count(21); left > 0; --left)
        result.entities.push_back(entity());
    if ((flags & hasReview) != 0) result.review = review();
    if ((flags & hasOrigin) != 0) result.origin = origin();
    return result;
  }
  ReviewMark review() {
    ReviewMark result;
    const auto state = number<std::uint8_t>();
    if (state > static_cast<std::uint8_t>(ReviewState::reviewed)) throw Malformed{};
    result.state = static_cast<ReviewState>(state);
    result.comment = text();
    result.reviewer = text();
    return result;
  }
  RadiusOrigin origin() {
    RadiusOrigin result;
    const auto source = number<std::uint8_t>();
    if (source > static_cast<std::uint8_t>(RadiusSource::byHand)) throw Malformed{};
    result.source = static_cast<RadiusSource>(source);
    result.least = std::bit_cast<float>(number<std::uint32_t>());
    result.most = std::bit_cast<float>(number<std::uint32_t>());
    if (!result.isSound()) throw Malformed{};
    return result;
  }
  PointSet points() {
    if (written_ < 3) return {};
    std::vector<PointSet::Run> runs;
    for (std::size_t left = count(8); left > 0; --left) {
      const auto begin = number<std::uint32_t>();
      runs.push_back({begin, number<std::uint32_t>()});
    }
    std::optional<PointSet> set = PointSet::ofRuns(std::move(runs));
    if (!set) throw Malformed{};
    return *std::move(set);
  }
  OrganMarks organs() {
    if (written_ < bytesVersion) return {};
    OrganMarks::Sets sets;
    for (PointSet& set : sets)
      set = points();
    OrganMarks result(std::move(sets));
    if (result.isEmpty()) throw Malformed{}; // as it is never written
    return result;
  }
  void end() const {
    if (!rest_.empty()) throw Malformed{};
  }

private:
  std::string_view rest_; // not read yet
  std::uint8_t written_;  // the version it was written in
};

constexpr std::size_t leastNode = 33; // bytes: flags, position, radius

Skeleton readSkeleton(Reader& reader) {
  Skeleton skeleton;
  const auto end = reader.number<std::uint32_t>();
  if (end > mostIds) throw Malformed{};
  const std::size_t count = reader.count(4 + leastNode);
  growIds(skeleton, end);
  for (std::size_t left = count; left > 0; --left) {
    const NodeId id = reader.id();
    const Node node = reader.node();
    const bool isNew = indexOf(id) < end && !skeleton.contains(id);
    if (!isNew || (node.parent && !skeleton.contains(*node.parent))) throw Malformed{};
    skeleton.restore(id, node);
  }
  return skeleton;
}

SkeletonDelta readDelta(Reader& reader) {
  SkeletonDelta delta;
  const std::size_t count = reader.count(5 + leastNode);
  delta.changes.reserve(count);
  for (std::size_t left = count; left > 0; --left) {
    SkeletonDelta::Change change{reader.id(), std::nullopt, std::nullopt};
    const auto flags = reader.number<std::uint8_t>();
    if ((flags & hasBefore) != 0) change.before = reader.node();
    if ((flags & hasAfter) != 0) change.after = reader.node();
    delta.changes.push_back(std::move(change));
  }
  return delta;
}

} // namespace

std::string bytesOf(const SkeletonDelta& delta, const PointSet& points, const OrganMarks& organs) {
  Writer writer;
  writer.size(delta.changes.size());
  for (const SkeletonDelta::Change& change : delta.changes) {
    writer.id(change.id);
    writer.number(
        static_cast<std::uint8_t>((change.before ? hasBefore : 0) | (change.after ? hasAfter : 0)));
    if (change.before) writer.node(change.id, *change.before);
    if (change.after) writer.node(change.id, *change.after);
  }
  writer.points(points);
  writer.organs(organs);
  return writer.finished();
}

std::optional<StoredDelta> deltaFrom(std::string_view bytes) {
  try {
    Reader reader(bytes);
    StoredDelta stored{.delta = readDelta(reader)};
    stored.points = reader.points();
    stored.organs = reader.organs();
    reader.end();
    return stored;
  } catch (const Malformed&) {
    return std::nullopt;
  }
}

std::string bytesOf(const Skeleton& skeleton, const PointSet& leftOut, const OrganMarks& organs) {
  const std::vector<NodeId> ids = skeleton.ids();
  Writer writer;
  const std::size_t used = ids.empty() ? 0 : indexOf(*std::ranges::max_element(ids)) + 1;
  writer.size(storedIdEnd(skeleton.idEnd(), used));
  writer.size(skeleton.size());
  for (const NodeId id : ids) { // parents first: a reader needs no second look
    writer.id(id);
    writer.node(id, skeleton[id]);
  }
  writer.points(leftOut);
  writer.organs(organs);
  return writer.finished();
}

std::optional<StoredPlant> plantFrom(std::string_view bytes) {
  try {
    Reader reader(bytes);
    StoredPlant stored{.skeleton = readSkeleton(reader)};
    stored.leftOut = reader.points();
    stored.organs = reader.organs();
    reader.end();
    return stored;
  } catch (const Malformed&) {
    return std::nullopt;
  }
}

std::size_t idsFor(std::size_t bytes) {
  constexpr std::size_t always = std::size_t{1} << 22;
  return std::min(mostIds, always + bytes / 2);
}

std::size_t storedIdEnd(std::size_t handedOut, std::size_t used) {
  return handedOut <= idsFor(0) ? handedOut : used;
}

std::size_t idEndOf(std::string_view bytes) {
  std::size_t end = 0;
  for (std::size_t i = 0; i < 4 && i + 1 < bytes.size(); ++i)
    end |= std::size_t{static_cast<unsigned char>(bytes[i + 1])} << (8 * i);
  return end;
}

} // namespace espalier
