#pragma once

#include "core/skeleton/skeleton.h"
#include "core/skeleton/skeleton_delta.h"
#include "ui/document/tool_input.h"
#include "ui/view/node_look.h"

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
enum class Fading : std::uint8_t { byDepth, faded, whole }; // whole: whatever its depth
enum class Mark : std::uint8_t { none, selected, hovered, both };

/// A node as it is drawn. The layout is read by the shaders.
struct NodeGlyph {
  std::array<float, 3> position{}; // [L], about the origin of the glyphs
  float radius = 0;                // [L]
  NodeShape shape = NodeShape::none;
  Mark mark = Mark::none;
  bool isUnitStart = false; // marked as one by hand
  Fading fading = Fading::byDepth;
  std::array<std::uint8_t, 4> color{}; // its own, if the last is not 0

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
  Fading fading = Fading::byDepth;
  std::uint8_t unused = 0;
  std::array<std::uint8_t, 4> color{}; // as that of a node

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
  /// Keeps the marks, but not what is hidden, faded, whole or colored: ids may mean other nodes
  /// now.
  void rebuild(const Skeleton& skeleton, const Eigen::Vector3d& origin);
  void update(const Skeleton& skeleton, const SkeletonDelta& delta);
  /// Draws about another origin, without the skeleton at hand; keeps 7 digits of the nodes' shift.
  void moveOrigin(const Eigen::Vector3d& origin);
  void select(const std::vector<NodeId>& nodes); // ids that are gone are ignored
  bool hover(const Pick& pick);                  // returns whether that changed anything

  // How nodes look, each with the edge to its parent. O(nodes); edits keep it, at the cost of
  // their size. Ids that are not there yet count once they are.
  void setHidden(const std::vector<NodeId>& nodes); // not drawn; nor is an edge at one
  [[nodiscard]] bool isHidden(NodeId id) const;
  /// Fades all but some nodes; none: fades nothing. A child added to one of them is one of them.
  void setFaded(const std::optional<std::vector<NodeId>>& allBut);
  /// Nodes that are not faded by depth where something is in focus, unless setFaded() fades them.
  void setWhole(const std::vector<NodeId>& nodes);
  /// What is given is drawn once setColorMap() has said in which colors.
  void setColors(std::optional<NodeColors> colors) { colors_ = std::move(colors); }
  void setColorMap(std::optional<LegendColors> map);
  [[nodiscard]] const Legend* legend() const { return colors_ ? &colors_->legend : nullptr; }

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
  void dressNode(std::size_t slot); // shape and color, by what it is and how it is to look
  void dressEdge(std::size_t slot);
  void dressAll();
  [[nodiscard]] bool isHiddenSlot(std::size_t slot) const;
  [[nodiscard]] bool isFadedSlot(std::size_t slot) const;
  [[nodiscard]] Fading fadingOf(std::size_t slot) const;
  [[nodiscard]] std::array<std::uint8_t, 4> colorOf(std::size_t slot) const;
  void mark(std::size_t slot, Mark mark);
  [[nodiscard]] Mark markOf(std::size_t slot) const;

  std::vector<NodeGlyph> nodes_;
  std::vector<EdgeGlyph> edges_;
  /// What is drawn in a slot unless it is hidden.
  struct Slot {
    NodeShape node = NodeShape::none;
    EdgeShape edge = EdgeShape::none;
    std::size_t parent = 0; // of the edge
  };
  std::vector<Slot> slots_;
  std::vector<bool> hidden_;               // by slot; may end before the last
  std::optional<std::vector<bool>> vivid_; // likewise: not faded; none: nothing is faded
  std::vector<bool> whole_;                // likewise: not faded by depth
  std::optional<NodeColors> colors_;
  std::optional<LegendColors> colorMap_; // of what colors_ stand for
  std::vector<bool> selected_;           // by slot
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
