#pragma once

#include "app/window/frame/window_part.h"
#include "core/mtg/unit_scales.h"
#include "ui/document/plant_document.h"

class QWidget;

namespace espalier {

class ActionSet;
class CommitMarksDialog;
class InspectorPanel;
struct UnitPart;

/// Scales by hand: the commands on marks, and what is typed about units in the inspector.
class UnitFlow : public WindowPart {
  Q_OBJECT

public:
  UnitFlow(PlantDocument& document, ActionSet& actions, InspectorPanel& inspector, QWidget& window);

  void setEnabled(bool isEnabled) override;
  [[nodiscard]] QString furtherHint() const override;
  [[nodiscard]] QString count() const override;

private:
  void commit();
  void clear();
  void addFeature(const UnitPart& part);
  void addDate(const UnitPart& part);
  bool edit(const QString& name, const std::function<void(SkeletonEditor&)>& change,
            QWidget* field);
  void recount(const SkeletonDelta& delta);
  void setMarks(std::size_t marks);
  void refreshEnabled();

  PlantDocument& document_;
  ActionSet& actions_;
  QWidget& window_;
  std::size_t marks_ = 0; // nodes that are marked
  bool isEnabled_ = true;
};

} // namespace espalier
