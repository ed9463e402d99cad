#pragma once

#include "core/pipeline/scan_measures.h"
#include "ui/document/length_unit.h"

#include <QWidget>

#include <optional>
#include <vector>

class QGridLayout;
class QLabel;
class QToolButton;

namespace espalier {

/// What a measure is, what it was found to be, and what that means.
struct MeasureText {
  QString name;
  QString value;
  QString help; // a sentence
};

/// The measures of a scan as people read them; without those that its points do not show.
[[nodiscard]] std::vector<MeasureText> measureTexts(const ScanMeasures& measures, LengthUnit unit);

/// What the points of the scan are like: a line, and once it is opened all that was measured, of
/// the whole scan and by height. Absent without a scan.
class MeasuresForm : public QWidget {
  Q_OBJECT

public:
  explicit MeasuresForm(QWidget* parent = nullptr);

  /// pre: there is a scan
  void showMeasured(const ScanMeasures& measures, LengthUnit unit);
  void showMeasuring(); // of a scan, or of other points of it: those shown are no longer true
  void showNone();      // there is no scan
  void setOpen(bool isOpen);

private:
  void fill(const ScanMeasures& measures, LengthUnit unit);
  void fillSlabs(const ScanMeasures& measures, LengthUnit unit, int row);

  QToolButton* header_;
  QLabel* summary_;
  QWidget* body_;
  QGridLayout* grid_;
  bool isMeasured_ = false;
};

} // namespace espalier
