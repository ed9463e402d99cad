#pragma once

#include "app/window/frame/window_part.h"
#include "app/window/preview/preview_flow.h"
#include "ui/jobs/job_slot.h"

#include <cstdint>
#include <optional>

class QAction;
class QActionGroup;
class QGridLayout;

namespace espalier {

class ActionSet;
class BlendBar;
class PlantDocument;
class PlantView;
class ReconstructFlow;
class TwoViewsFlow;

/// Compares two states of the plant: A, which was kept, or else the plant as it is, and what the
/// preview shows, or else the plant. Beside a divider, in two views, or one after the other. And
/// moves the points of what is shown between where they were scanned and where they are contracted.
class StatesFlow : public WindowPart {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    PlantDocument& document;
    JobQueue& queue;
    PlantView& view;
    ActionSet& actions;
    ReconstructFlow& reconstruct;
    PreviewFlow& preview;
    TwoViewsFlow& twoViews;
    QWidget& center; // its layout gets the bar that blends
  };
  explicit StatesFlow(const Parts& parts);

  void setPlantShown(bool isShown) override;
  /// What was kept as A; none: nothing was.
  [[nodiscard]] const std::optional<Outcome>& kept() const { return kept_; }
  void keep(const Outcome& outcome);
  [[nodiscard]] Outcome plant() const; // as it is

signals:
  void changed(); // what is kept

private:
  enum class Arrangement : std::uint8_t { preview, divided, twoViews };
  void addActions();
  void makeBar();
  void keepAsA();
  void forgetA();
  void arrange();
  void holdPlant();
  void showA();
  [[nodiscard]] bool replacesPoints() const; // A, by its contracted points
  void blend();
  void colorDifferences();

  Parts parts_;
  QActionGroup* arrangements_;
  bool hasOpenedSecond_ = false; // the second view is there for the comparison alone
  Arrangement arrangement_ = Arrangement::preview;
  BlendBar* bar_ = nullptr;
  bool isPlantShown_ = false;
  double divider_ = 0.5;
  std::optional<Outcome> kept_;
  bool areReplaced_ = false; // the points of A, as it is shown
  JobSlot differences_{parts_.queue, JobPriority::asked};
};

} // namespace espalier
