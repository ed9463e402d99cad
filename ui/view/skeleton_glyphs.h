#pragma once

#include "core/skeleton/skeleton.h"
#include "core/skeleton/skeleton_delta.h"
#include "ui/document/tool_input.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace espalier {

enum class NodeShape : std::uint8_t { none, plain, root, apex, branching };
enum class EdgeShape : std::uint8_t { none, successor, branching };
enum class Mark : std::uint8_t { none, selected, hovered, both };

/// A node as it is drawn. The layout is read by the shaders.
struct NodeGlyph {
  std::array<float, 3> position{}; // [L], about the origin of the glyphs
  float radius = 0;                // [L]
  NodeShape shape = NodeShape::none;
  Mark mark = Mark::none;
  bool isUnitStart = false; // marked as one by hand
  std::uint8_t unused = 0;

  bool operator==(const NodeGlyph&) const = default;
};

/// The edge from a node to its parent as it is drawn. The layout is read by the shaders.
struct EdgeGlyph {
  std::array<float, 3> parent{};
  float parentRadius = 0;
  std::array<float, 3> child{};
  float childRadius = 0;
  EdgeShape shape = EdgeShape::none;
  Mark mark = Mark::none;
  std::array<std::uint8_t, 2> unused{};

  bool operator==(const EdgeGlyph&) const = default;
};

/// Slots [begin, end) that changed since they were last drawn.
struct SlotRange {
  std::size_t begin = SIZE_MAX;
  std::size_t end = 0;

  [[nodiscard]] bool isEmpty() const { return begin >= end; }
  void add(std::size_t slot);
};

/// A skeleton as glyphs. The slot of a node, and of the edge to its parent, is its id: an edit
/// touches the slots of its nodes and of their children only.
class SkeletonGlyphs {
public:
  void rebuild(const Skeleton& skeleton, const Eigen::Vector3d& origin); // keeps the marks
  void update(const Skeleton& skeleton, const SkeletonDelta& delta);
  /// Draws about another origin, without the skeleton at hand; keeps 7 digits of the nodes' shift.
  void moveOrigin(const Eigen::Vector3d& origin);
  void select(const std::vector<NodeId>& nodes); // ids that are gone are ignored
  bool hover(const Pick& pick);                  // returns whether that changed anything

  [[nodiscard]] const std::vector<NodeGlyph>& nodes() const { return nodes_; }
  [[nodiscard]] const std::vector<EdgeGlyph>& edges() const { return edges_; }
  [[nodiscard]] const Eigen::Vector3d& origin() const { return origin_; } // [L]
  [[nodiscard]] Eigen::Vector3d position(std::size_t slot) const;         // [L], frame of the file

  /// Encloses all nodes [L], frame of the file. Grows with edits, shrinks when rebuilt.
  [[nodiscard]] const Eigen::AlignedBox3d& bounds() const { return bounds_; }
  /// Median length of an edge when much of the plant last changed [L]; 0 without edges.
  [[nodiscard]] double typicalLength() const { return typicalLength_; }

  [[nodiscard]] SlotRange takeChangedNodes() { return std::exchange(changedNodes_, {}); }
  [[nodiscard]] SlotRange takeChangedEdges() { return std::exchange(changedEdges_, {}); }

private:
  void place(const Skeleton& skeleton, NodeId id);     // its position and radius
  void shapeNode(const Skeleton& skeleton, NodeId id); // its shape
  void drawEdge(const Skeleton& skeleton, NodeId id);  // the edge to its parent
  void mark(std::size_t slot, Mark mark);
  [[nodiscard]] Mark markOf(std::size_t slot) const;

  std::vector<NodeGlyph> nodes_;
  std::vector<EdgeGlyph> edges_;
  std::vector<bool> selected_; // by slot
  std::vector<NodeId> selection_;
  std::optional<NodeId> hoveredNode_;
  std::optional<NodeId> hoveredEdge_; // by its child
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  Eigen::AlignedBox3d bounds_;
  double typicalLength_ = 0;
  SlotRange changedNodes_;
  SlotRange changedEdges_;
};

} // namespace espalier
