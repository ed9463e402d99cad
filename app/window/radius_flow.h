#pragma once

#include "core/radius/section_circle.h"

#include <QObject>
#include <QString>
#include <QStringList>

#include <functional>
#include <vector>

namespace espalier {

class ActionSet;
class CrossSectionPanel;
class JobRunner;
class PlantDocument;
class PlantView;

/// Radii: the commands of the Radius menu, and what is dragged in the cross-section.
class RadiusFlow : public QObject {
  Q_OBJECT

public:
  struct Parts {
    PlantDocument& document;
    JobRunner& jobs;
    ActionSet& actions;
    PlantView& view;
    CrossSectionPanel& section;
  };

  explicit RadiusFlow(const Parts& parts);

  /// The ids of the actions of the menu; an empty one is a separator.
  [[nodiscard]] static QStringList menu();

  void setEnabled(bool isEnabled);    // off while a job runs that replaces the skeleton
  [[nodiscard]] QString hint() const; // what the mouse does in the cross-section; empty outside it

signals:
  void done(const QString& message);  // of a step that left nodes as they were, or took long
  void noted(const QString& message); // nothing has changed
  void hintChanged();

private:
  void addMeasures();
  void addModels();
  void connectSection();
  void setMeasured(RadiusMeasure measure);
  void pipeModel();
  void pipeModelAroundMeasured();
  void smooth();
  void limit();
  void refreshEnabled();
  void showRing();
  [[nodiscard]] std::vector<NodeId> chosen() const;
  /// Measures nodes, as a job if they are many, then acts.
  void measure(const std::vector<NodeId>& nodes, RadiusMeasure measure,
               const std::function<void(const SectionRadii&)>& act);

  Parts parts_;
  bool isEnabled_ = true;
  bool isRingShown_ = false;
};

} // namespace espalier
