#pragma once

#include <QWidget>

class QTableView;

namespace espalier {

class HistoryModel;
class PlantDocument;

/// The list of all steps, the present one marked.
class HistoryPanel : public QWidget {
  Q_OBJECT

public:
  /// @param document must outlive it
  explicit HistoryPanel(PlantDocument& document, QWidget* parent = nullptr);

signals:
  void chosen(int position); // by a click or Enter: how many steps are to be done

protected:
  void showEvent(QShowEvent* event) override;

private:
  void showPresent();
  void choose(int row);

  HistoryModel* model_;
  QTableView* list_;
};

} // namespace espalier
