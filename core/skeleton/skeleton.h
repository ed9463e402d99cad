#pragma once

#include "core/skeleton/entity.h"
#include "core/skeleton/radius_origin.h"
#include "core/skeleton/review_mark.h"

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace espalier {

enum class NodeId : std::uint32_t {}; // its own type: cannot be mixed up with a point index
enum class EdgeType : char { successor = '<', branching = '+' }; // to the parent, as in an MTG

struct Node {
  Eigen::Vector3d position = Eigen::Vector3d::Zero(); // [L], frame of the file
  double radius = 0;                                  // [L], 0 until estimated
  std::optional<NodeId> parent;                       // none for a root
  EdgeType edge = EdgeType::successor;                // without meaning for a root
  std::vector<Entity> entities = {}; // of an MTG, that start here: coarsest first, its own last
  bool isMarked = false; // by hand: a unit is to start here (core/mtg/unit_edits.h). Never exported
  ReviewMark review = {};
  RadiusOrigin origin = {}; // of the radius

  bool operator==(const Node&) const = default;
};

/// Curve skeleton of a plant: a rooted forest of nodes.
///
/// Invariants: each parent exists; no cycle. (Two successors of one node are legal in files of
/// others: `check` finds them, nothing refuses them.) Ids are stable: an edit renumbers no node it
/// keeps and never hands out an erased id again.
class Skeleton {
public:
  [[nodiscard]] std::vector<NodeId> ids() const;   // parents before their children
  [[nodiscard]] std::vector<NodeId> roots() const; // lowest id first
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool isEmpty() const { return size_ == 0; }
  [[nodiscard]] bool contains(NodeId id) const;
  [[nodiscard]] const Node& operator[](NodeId id) const;              // pre: contains(id)
  [[nodiscard]] const std::vector<NodeId>& children(NodeId id) const; // pre: contains(id)

  /// One more than the highest id ever handed out: tables by id have this size.
  [[nodiscard]] std::size_t idEnd() const { return nodes_.size(); }

  void reserve(std::size_t nodes); // memory for that many, once

  /// @throws Error if the parent is missing
  NodeId add(const Node& node);
  void setPosition(NodeId id, const Eigen::Vector3d& position); // pre: contains(id)
  /// pre: contains(id), radius >= 0
  void setRadius(NodeId id, double radius, const RadiusOrigin& origin = {});
  void setEdge(NodeId id, EdgeType edge);                    // pre: contains(id)
  void setEntities(NodeId id, std::vector<Entity> entities); // pre: contains(id)
  void setMarked(NodeId id, bool isMarked);                  // pre: contains(id)
  void setReview(NodeId id, ReviewMark review);              // pre: contains(id)

  /// Attaches `id`, with all it carries, to `parent`.
  /// @throws Error if `parent` is `id` or a descendant of it
  void reparent(NodeId id, NodeId parent, EdgeType edge);
  void makeRoot(NodeId id); // pre: contains(id); keeps what it carries

  void erase(NodeId id);                     // pre: contains(id), no children
  void restore(NodeId id, const Node& node); // pre: !contains(id), id was handed out before

  [[nodiscard]] bool isAncestor(NodeId ancestor, NodeId of) const; // a node is its own ancestor

  /// Equal nodes under equal ids. Ids that were erased do not count.
  bool operator==(const Skeleton& other) const;

private:
  void link(NodeId id);
  void unlink(NodeId id);

  std::vector<std::optional<Node>> nodes_;    // by id; empty once erased
  std::vector<std::vector<NodeId>> children_; // by id: successors first, then by id
  std::size_t size_ = 0;
};

[[nodiscard]] constexpr std::size_t indexOf(NodeId id) {
  return static_cast<std::size_t>(id);
}

[[nodiscard]] std::string nameOf(NodeId id); // "node 12", in messages

} // namespace espalier
