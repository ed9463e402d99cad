#include "core/project/structure_hash.h"

#include "core/project/content_hash.h"

#include <bit>
#include <string>

namespace espalier {
namespace {

// Bytes of their own, not those of node_bytes.h: a later version of these must not break a seal.
class NodeText {
public:
  void number(std::uint64_t value) {
    for (int i = 0; i < 8; ++i)
      bytes_.push_back(static_cast<char>((value >> (8 * i)) & 0xFF));
  }
  void real(double value) { number(std::bit_cast<std::uint64_t>(value + 0.0)); } // -0 is 0
  void text(const std::string& text) {
    number(text.size());
    bytes_ += text;
  }
  void values(const std::vector<FeatureValue>& values) {
    number(values.size());
    for (const FeatureValue& value : values) {
      text(value.feature);
      text(value.text);
    }
  }
  void entity(const Entity& entity) {
    number(static_cast<std::uint64_t>(entity.scale));
    text(entity.symbol);
    number(entity.index ? 1 : 0);
    number(static_cast<std::uint64_t>(entity.index ? entity.index->number() : 0));
    if (entity.index && !entity.index->isPlain()) text(entity.index->text());
    text(entity.alias);
    values(entity.values);
    number(entity.later.size());
    for (const std::vector<FeatureValue>& date : entity.later)
      values(date);
  }

  [[nodiscard]] const std::string& bytes() const { return bytes_; }

private:
  std::string bytes_;
};

std::uint64_t hashOf(NodeId id, const Node& node) {
  NodeText text;
  text.number(indexOf(id));
  for (int i = 0; i < 3; ++i)
    text.real(node.position[i]);
  text.real(node.radius);
  text.number(node.parent ? indexOf(*node.parent) + 1 : 0);
  text.number(node.parent && node.edge == EdgeType::branching ? 1 : 0);
  text.number(static_cast<std::uint64_t>(node.review.state));
  text.number(node.entities.size());
  for (const Entity& entity : node.entities)
    text.entity(entity);
  return contentHash(text.bytes());
}

} // namespace

StructureHash::StructureHash(const Skeleton& skeleton) {
  for (const NodeId id : skeleton.ids())
    sum_ += hashOf(id, skeleton[id]);
}

void StructureHash::apply(const SkeletonDelta& delta) {
  for (const SkeletonDelta::Change& change : delta.changes) {
    if (change.before) sum_ -= hashOf(change.id, *change.before);
    if (change.after) sum_ += hashOf(change.id, *change.after);
  }
}

} // namespace espalier
