#pragma once

#include "core/skeleton/skeleton.h"

#include <QObject>

#include <optional>
#include <span>
#include <vector>

namespace espalier {

/// The chosen nodes of a document, each once, in the order they were chosen. To find whether a node
/// is one of them takes constant time, changing them time linear in their number.
class Selection : public QObject {
  Q_OBJECT

public:
  using QObject::QObject;

  [[nodiscard]] const std::vector<NodeId>& nodes() const { return nodes_; }
  [[nodiscard]] bool isEmpty() const { return nodes_.empty(); }
  [[nodiscard]] bool contains(NodeId id) const;
  /// The node chosen last: whose properties are shown.
  [[nodiscard]] std::optional<NodeId> current() const;

  void set(std::vector<NodeId> nodes);
  void toggle(NodeId id);
  void clear() { set({}); }

  /// Leaves out the nodes that `skeleton` does not have.
  void keepThoseIn(const Skeleton& skeleton);

signals:
  void changed();

private:
  void note(std::span<const NodeId> nodes, bool areChosen);

  std::vector<NodeId> nodes_;
  std::vector<bool> isChosen_; // by id, as far as any was chosen
};

} // namespace espalier
