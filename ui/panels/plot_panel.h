#pragma once

#include <QString>
#include <QWidget>

#include <cstddef>
#include <vector>

class QCheckBox;
class QLabel;
class QPushButton;
class QTableWidget;

namespace espalier {

/// Finds the plants of a plot, lists them, and offers to write each as a project of its own.
class PlotPanel : public QWidget {
  Q_OBJECT

public:
  explicit PlotPanel(QWidget* parent = nullptr);

  struct Plant {
    QString points; // "24 871"
    QString height; // "1.25 m"
    bool operator==(const Plant&) const = default;
  };
  /// The plants found, by their places, all to be written; of the same as before, those that were.
  /// @param words  of what was found
  void showPlants(const std::vector<Plant>& plants, const QString& words);
  void showNone(const QString& words); // and why
  void showWorking(const QString& words);
  void setFindable(bool isFindable); // with a scan
  void setCleans(bool isOn);
  [[nodiscard]] bool cleans() const;                     // leave out ground, poles and wires first
  [[nodiscard]] std::vector<std::size_t> chosen() const; // to be written: their places, ascending

signals:
  void findRequested();
  void cleansChanged(); // what was found is another's
  void writeRequested();
  void cancelRequested();
  void pointedAt(std::size_t plant); // its row is the current one

private:
  void refresh();

  QLabel* words_;
  QCheckBox* cleans_;
  QPushButton* find_;
  QTableWidget* table_;
  QPushButton* write_;
  QPushButton* cancel_;
  bool isFindable_ = false;
  bool isWorking_ = false;
  std::vector<Plant> shown_;
};

} // namespace espalier
