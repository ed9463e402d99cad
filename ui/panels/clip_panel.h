#pragma once

#include <Eigen/Geometry>
#include <QWidget>

#include <array>

class QCheckBox;
class QDoubleSpinBox;
class QGridLayout;
class QSlider;

namespace espalier {

/// Fields for which part of the plant is shown: a slab facing the viewer, a box, and how far the
/// back steps back.
class ClipPanel : public QWidget {
  Q_OBJECT

public:
  struct Values {
    bool hasSlab = false;
    double nearest = 0;  // of the slab: part of the depth of the plant, in [0, 1]
    double farthest = 1; // likewise, >= nearest
    bool hasBox = false;
    Eigen::AlignedBox3d box; // [L]; empty: not chosen yet
    double fade = 0;         // [0, 1]
    double around = 0;       // what one flew to: how far all else fades, likewise
  };

  explicit ClipPanel(QWidget* parent = nullptr);

  /// What the fields range over, and what a box is at first [L]; empty: there is no plant.
  void setBounds(const Eigen::AlignedBox3d& bounds);
  void setUnit(const QString& unit);
  void setValues(const Values& values); // notifies nobody
  [[nodiscard]] Values values() const;

signals:
  void changed();
  void showAllRequested();

private:
  void addSlab(QGridLayout& grid);
  void addBox(QGridLayout& grid);
  QSlider* addSlider(QGridLayout& grid, const QString& name, const QString& label, int value);
  void keepApart(const QSlider* moved);
  void refresh();

  QCheckBox* slab_ = nullptr;
  QSlider* nearest_ = nullptr;
  QSlider* farthest_ = nullptr;
  QCheckBox* box_ = nullptr;
  std::array<QDoubleSpinBox*, 3> low_{};
  std::array<QDoubleSpinBox*, 3> high_{};
  QSlider* fade_ = nullptr;
  QSlider* around_ = nullptr;
  Eigen::AlignedBox3d bounds_;
};

} // namespace espalier
