#pragma once

#include "core/skeleton/skeleton_delta.h"

#include <QWidget>

#include <functional>
#include <optional>

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QPushButton;

namespace espalier {

class CrossSectionPanel;
class PlantDocument;
class UnitsForm;
struct UnitPart;

/// The properties of the chosen node, or how many are chosen. What can be typed is reported as a
/// signal: the window makes the edit.
class InspectorPanel : public QWidget {
  Q_OBJECT

public:
  explicit InspectorPanel(PlantDocument& document, QWidget* parent = nullptr);

  [[nodiscard]] CrossSectionPanel& crossSection() const { return *section_; }

signals:
  void leaveRequested();           // the number is complete: the keys are the plant's again
  void radiusTyped(double radius); // [L], for all chosen nodes
  void edgeChosen(espalier::EdgeType type);
  void nodeChosen(espalier::NodeId id);
  /// What an MTG says of the node or of its units; as in UnitsForm.
  void unitTyped(const QString& name, const std::function<void(espalier::SkeletonEditor&)>& change,
                 QWidget* field);
  void featureRequested(const espalier::UnitPart& part);
  void dateRequested(const espalier::UnitPart& part);

private:
  void makeForm();
  void refresh();
  void showNode(NodeId id);
  void showNodes();
  void showRadius(double radius, const QString& name, const QString& help);
  void showOrigin(const QString& text);

  PlantDocument& document_;
  QLabel* title_;
  QLabel* empty_;
  QWidget* body_;
  QFormLayout* form_;
  QLabel* order_;
  QComboBox* edge_;
  QPushButton* parent_;
  QLabel* children_;
  QLabel* position_;
  QLabel* length_;
  QDoubleSpinBox* radius_;
  QLabel* origin_; // of the radius
  CrossSectionPanel* section_;
  UnitsForm* units_;
};

} // namespace espalier
