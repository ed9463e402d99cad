#pragma once

#include "core/mtg/unit_scales.h"
#include "ui/document/plant_document.h"

#include <QObject>
#include <QPointer>
#include <QWidget>

namespace espalier {

class ActionSet;
class CommitMarksDialog;
class InspectorPanel;
struct UnitPart;

/// Scales by hand: the commands on marks, and what is typed about units in the inspector.
class UnitFlow : public QObject {
  Q_OBJECT

public:
  UnitFlow(PlantDocument& document, ActionSet& actions, InspectorPanel& inspector, QWidget& window);

  void setEnabled(bool isEnabled); // off while a job runs that replaces the skeleton
  [[nodiscard]] std::size_t marks() const { return marks_; } // nodes that are marked
  /// Where the text stands that was refused last; null: it is gone.
  [[nodiscard]] QWidget* field() const { return field_; }

signals:
  void marksChanged();

private:
  void commit();
  void clear();
  void addFeature(const UnitPart& part);
  void addDate(const UnitPart& part);
  bool edit(const QString& name, const std::function<void(SkeletonEditor&)>& change,
            QWidget* field);
  void count(const SkeletonDelta& delta);
  void setMarks(std::size_t marks);
  void refreshEnabled();

  PlantDocument& document_;
  ActionSet& actions_;
  QWidget& window_;
  QPointer<QWidget> field_;
  std::size_t marks_ = 0;
  bool isEnabled_ = true;
};

} // namespace espalier
