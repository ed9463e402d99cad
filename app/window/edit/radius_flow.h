#pragma once

#include "app/window/frame/window_part.h"
#include "core/radius/section_circle.h"

#include <QString>
#include <QStringList>

#include <functional>
#include <vector>

namespace espalier {

class ActionSet;
class CrossSectionPanel;
class JobSlot;
class PlantDocument;
class PlantView;

/// Radii: the commands of the Radius menu, and what is dragged in the cross-section.
class RadiusFlow : public WindowPart {
  Q_OBJECT

public:
  struct Parts {
    PlantDocument& document;
    JobSlot& jobs;
    ActionSet& actions;
    PlantView& view;
    CrossSectionPanel& section;
  };

  explicit RadiusFlow(const Parts& parts);

  void setEnabled(bool isEnabled) override;
  [[nodiscard]] QString hint() const override; // in the cross-section

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
