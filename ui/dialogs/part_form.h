#pragma once

#include "core/io/points/point_glance.h"
#include "core/io/points/read_options.h"

#include <QWidget>

#include <array>
#include <cstdint>

class QCheckBox;
class QDoubleSpinBox;
class QLabel;
class QRadioButton;

namespace espalier {

class CountBox;

/// How much of a scan is read: all points or a sample, wherever they lie or in a box; with the
/// memory that they will take.
class PartForm : public QWidget {
  Q_OBJECT

public:
  /// @param mostAtOnce  of a scan with more points, a sample of as many is proposed
  PartForm(const PointGlance& glance, std::uint64_t mostAtOnce, QWidget* parent = nullptr);

  void setGlance(const PointGlance& glance); // found out anew, of other columns
  void choose(ReadOptions& options) const;
  void show(const ReadOptions& options); // as choose() gave them
  [[nodiscard]] QString problem() const; // in a sentence; empty: none

signals:
  void changed();

private:
  void makeBox();
  void fillBox();
  void refresh();
  [[nodiscard]] bool hasMoreBeyond() const; // the bounds, as they are of a sample
  [[nodiscard]] Eigen::AlignedBox3d box() const;

  PointGlance glance_;
  QRadioButton* all_;
  QLabel* allText_;
  QRadioButton* some_;
  CountBox* most_;
  QLabel* someText_;
  QCheckBox* isBoxed_;
  QLabel* boxText_;
  QWidget* sides_;
  std::array<std::array<QDoubleSpinBox*, 2>, 3> ends_; // by axis
  std::array<std::array<double, 2>, 3> filled_;        // likewise, as the bounds filled them in
};

} // namespace espalier
