#pragma once

#include "core/skeleton/skeleton.h"

#include <QTimer>
#include <QWidget>

#include <vector>

class QCheckBox;
class QLabel;
class QLineEdit;
class QTableView;

namespace espalier {

class NodeTableModel;
class PlantDocument;

/// All nodes of a plant, or the selected ones, as a table. Its rows are selected as the nodes are,
/// and the nodes as its rows. While it is hidden it costs nothing.
class NodeTablePanel : public QWidget {
  Q_OBJECT

public:
  /// @param document must outlive it
  explicit NodeTablePanel(PlantDocument& document, QWidget* parent = nullptr);

  /// The selected rows, or all if none is, as NodeTableModel::tableOf.
  [[nodiscard]] QString table() const;
  [[nodiscard]] NodeTableModel& model() { return *model_; }

signals:
  void copyRequested();

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  bool goesToRow(int key);
  void showEvent(QShowEvent* event) override;

private:
  void makeTable();
  void widenToNames();
  void refresh();
  void connectParts();
  void useFilter();
  void showSelection();
  void takeSelection();
  void listSelected();
  void refreshCount();

  PlantDocument& document_;
  NodeTableModel* model_;
  QTableView* table_;
  QLineEdit* filter_;
  QCheckBox* onlySelected_;
  QLabel* count_;
  QLabel* wrong_;          // with the filter
  bool isSyncing_ = false; // rows and nodes are made equal: neither is to follow the other
  QTimer later_;
};

} // namespace espalier
