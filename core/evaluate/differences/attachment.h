#pragma once

#include "core/evaluate/differences/differences.h"
#include "core/skeleton/skeleton.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace espalier {

/// Where something is attached according to a reference.
struct Attachment {
  std::optional<NodeId> host;                      // of the result; none: it has nothing there
  Eigen::Vector3d place = Eigen::Vector3d::Zero(); // on the reference [L]
  EdgeType edge = EdgeType::branching;
  double height = 0; // of what the host stands on, along the reference [L]
};

struct WrongAttachment {
  NodeId node; // of the result: attached to what does not bear it in the reference
  Attachment right;
};

/// Which places of a reference the nodes of a result stand on, so that what is attached to what can
/// be compared: see differences(). Both skeletons must outlive it.
class Attachments {
public:
  /// @param kinds of the edges of the result, by id; nodes at none that is matched stand on nothing
  Attachments(const Skeleton& result, const Skeleton& reference,
              const std::vector<Difference>& kinds, double tolerance);

  [[nodiscard]] const std::vector<WrongAttachment>& wrong() const { return wrong_; }
  [[nodiscard]] std::vector<std::vector<NodeId>> standsOn() const; // by id of the result
  /// What of the result stands on the upper end of an edge of the reference, or next below it.
  [[nodiscard]] Attachment on(NodeId edge) const;

private:
  struct Place {
    NodeId edge;              // of the reference, by its upper node
    Eigen::Vector3d position; // on it [L]
    double height;            // along the reference, from its root [L]
  };
  using Places = std::vector<Place>;
  void measureReference();
  void placeNodes(const std::vector<Difference>& kinds);
  void findWrong(const std::vector<NodeId>& suspects);
  [[nodiscard]] bool leapsOver(NodeId id, const Attachment& right) const;
  [[nodiscard]] bool isAncestor(NodeId ancestor, NodeId of) const; // in the reference
  /// Does the path down from `above` in the reference meet `below`, or what is about it?
  [[nodiscard]] bool leadsTo(const Place& above, const Place& below) const;
  [[nodiscard]] Attachment below(const Place& place, NodeId attached) const;

  const Skeleton& result_;
  const Skeleton& reference_;
  double tolerance_;
  double slack_;                          // [L]
  std::vector<double> height_;            // of the nodes of the reference [L]
  std::vector<std::size_t> first_, last_; // by id of the reference: what it carries, in one order
  std::vector<Places> places_;            // by id of the result
  struct Standing {
    NodeId node; // of the result
    double height;
    Eigen::Vector3d position; // on the edge [L]
  };
  std::vector<std::vector<Standing>> standing_; // by edge of the reference
  std::vector<NodeId> leaps_; // of the result: what leads there is not of the reference
  std::vector<WrongAttachment> wrong_;
};

} // namespace espalier
