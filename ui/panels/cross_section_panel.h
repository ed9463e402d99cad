#pragma once

#include "core/radius/section_circle.h"
#include "core/skeleton/skeleton_delta.h"
#include "ui/document/gesture.h"
#include "ui/panels/cross_section_view.h"

#include <QWidget>

#include <functional>
#include <optional>
#include <vector>

class QComboBox;
class QLabel;
class QPushButton;

namespace espalier {

class PlantDocument;

/// The name of a measure, as in the menu.
[[nodiscard]] QString nameOf(RadiusMeasure measure);
/// Why there is no radius, in a few words: "too few points".
[[nodiscard]] QString reasonOf(NoRadius reason);

/// The cross-section of the chosen node, and the circles that can be measured in it. Absent unless
/// one node is chosen, over a scan. What is dragged or applied is reported as a signal: the window
/// makes the edit.
class CrossSectionPanel : public QWidget {
  Q_OBJECT

public:
  explicit CrossSectionPanel(PlantDocument& document, QWidget* parent = nullptr);

  void setEditable(bool isEditable); // off while a job runs that replaces the skeleton

  [[nodiscard]] bool isPointerInside() const { return isPointerInside_; } // the section
  /// In the plant, the circle of the node while the pointer is in the section [L]; else empty.
  [[nodiscard]] std::vector<Eigen::Vector3d> ring() const;

signals:
  /// A step named `name`. Edits of one gesture are one step.
  void edited(const QString& name, const std::function<void(espalier::SkeletonEditor&)>& change,
              espalier::Gesture gesture);
  void ringChanged();

private:
  void makeForm();
  void refresh();
  void showSection(bool keepView);
  void showNode();
  void showProposed();
  void refreshEditable();
  void ask(const SectionNode& node, Gesture gesture);
  void apply();
  [[nodiscard]] RadiusMeasure measure() const;
  [[nodiscard]] QString describe(const FittedCircle& circle) const;
  [[nodiscard]] QString describe(NoRadius reason) const;

  PlantDocument& document_;
  CrossSectionView* view_;
  QComboBox* measure_;
  QPushButton* apply_;
  QLabel* words_;
  std::optional<NodeId> node_; // shown
  std::optional<FittedCircle> proposed_;
  bool isEditable_ = true;
  bool isPointerInside_ = false;
  bool isOwnEdit_ = false;
};

} // namespace espalier
