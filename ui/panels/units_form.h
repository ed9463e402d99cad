#pragma once

#include "core/skeleton/skeleton_delta.h"
#include "ui/panels/unit_rows.h"

#include <QList>
#include <QStringList>
#include <QWidget>

#include <functional>

class QCheckBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QVBoxLayout;

namespace espalier {

class PlantDocument;

/// What an MTG says of a node and of the units it belongs to, finest first: class, index, features.
/// What is typed is reported as an edit, which the window makes: a wrong text is refused by it.
class UnitsForm : public QWidget {
  Q_OBJECT

public:
  explicit UnitsForm(PlantDocument& document, QWidget* parent = nullptr);

  void show(NodeId id); // and hides itself if the skeleton carries nothing of an MTG
  void showNothing();

signals:
  /// @param name   of the undo step
  /// @param field  where it was typed
  void typed(const QString& name, const std::function<void(espalier::SkeletonEditor&)>& change,
             QWidget* field);
  /// A feature that the plant does not have yet is to be typed for it, or values of a later date.
  void featureRequested(const espalier::UnitPart& part);
  void dateRequested(const espalier::UnitPart& part);
  void leaveRequested(); // what was typed is taken: the keys are the plant's again

private:
  void build(const QList<UnitPart>& parts);
  void makeFields();
  void addButtons(const UnitPart& part, QFormLayout& to);
  void requestValue(const QString& partId, bool isDate);
  void beginOrEnd(QCheckBox& begins);
  void addRow(const UnitRow& row, QFormLayout& to);
  bool take(QLineEdit& field);

  PlantDocument& document_;
  QVBoxLayout* column_;
  QWidget* body_ = nullptr;
  int shown_ = 0;     // how often
  QStringList shape_; // the ids of what is shown
  QList<UnitPart> parts_;
};

} // namespace espalier
