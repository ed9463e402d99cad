#pragma once

#include "core/mtg/structure.h"

#include <QWidget>

#include <memory>

class QLabel;
class QTreeView;

namespace espalier {

class VertexModel;

/// What is shown of a plant without its shape: that it has no positions, what can be done, and its
/// vertices with their scales and features.
class VertexPage : public QWidget {
  Q_OBJECT

public:
  explicit VertexPage(QWidget* parent = nullptr);

  /// @param keys  by which it is written
  void show(const std::shared_ptr<const MtgFrame>& frame, const QString& keys);
  void setFile(const QString& name); // that it is of

private:
  QLabel* headline_;
  QLabel* advice_;
  QLabel* counts_;
  VertexModel* model_;
  QTreeView* tree_;
  std::shared_ptr<const MtgFrame> frame_;
};

/// "Scale 1: 1 P · Scale 2: 10 A, 3 B · Edges: 9 <, 4 +"
[[nodiscard]] QString describe(const Mtg& mtg);

} // namespace espalier
