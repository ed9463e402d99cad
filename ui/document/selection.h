#pragma once

#include "core/skeleton/skeleton.h"

#include <QObject>

#include <optional>
#include <vector>

namespace espalier {

/// The chosen nodes of a document, in the order they were chosen.
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
  std::vector<NodeId> nodes_;
};

} // namespace espalier
