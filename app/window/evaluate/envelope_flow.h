#pragma once

#include "app/report/envelope_numbers.h"
#include "app/window/frame/panel_dock.h"
#include "app/window/frame/window_part.h"
#include "ui/document/gesture.h"
#include "ui/jobs/job_slot.h"
#include "ui/panels/envelope_panel.h"
#include "ui/view/envelope_overlay.h"

#include <QElapsedTimer>
#include <QTimer>

#include <memory>
#include <optional>
#include <string>

namespace espalier {

class PlantDocument;
class PlantView;

/// The envelope about the crown: it is fitted as a job, a moment after each change of the plant or
/// of what is chosen, drawn over the plant and measured. Its handles, where it has some, are shown
/// while the panel is. What is chosen and dragged is a step of the document.
class EnvelopeFlow : public WindowPart {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    PlantDocument& document;
    PlantView& view;
    JobQueue& queue;
    PanelDock::Parts window;
  };
  explicit EnvelopeFlow(const Parts& parts);

  [[nodiscard]] bool isBusy() const override { return job_.isBusy(); }
  void stop() override;
  void setPlantShown(bool isShown) override;
  [[nodiscard]] QString hint() const override; // over a handle

  /// As it is shown; none: it is not, or not of the plant as it is.
  [[nodiscard]] std::optional<ReportedEnvelope> reported() const;
  /// Writes the surface, as the name says: PLY or OBJ.
  /// @throws Error if that cannot be
  void write(const QString& path);

signals:
  void changed(); // what is reported

private:
  void takeChoice();
  void takeNew();
  void takePlant();
  void takeStep();
  void record(const QString& step, Gesture gesture = {});
  void fit();
  void showProgress(double fraction);
  void take(Envelope fitted, const EnvelopeKind& kind);
  void forget(const QString& words = {});
  void forgetDrawn(const QString& words);
  void show();
  void drag(std::size_t handle, const Eigen::Vector3d& to);
  void endDrag(bool isKept);
  void chooseFile();
  void refreshPanel();
  [[nodiscard]] bool isOfSkeleton() const;
  [[nodiscard]] bool isOfChosenKind() const; // what is drawn; another waits to be fitted
  [[nodiscard]] bool isByHand() const;
  [[nodiscard]] QString handleText() const;
  [[nodiscard]] QString choiceText(const EnvelopeChoice& before) const;
  [[nodiscard]] std::vector<EnvelopePanel::Number> numbers() const;
  [[nodiscard]] ShownEnvelope shown() const;
  [[nodiscard]] std::string text() const;
  void showText(const std::string& text);
  void showState(const EnvelopeChoice& choice, const HandlePlaces& places);

  Parts parts_;
  EnvelopePanel* panel_ = nullptr;
  PanelDock* dock_ = nullptr;
  QTimer timer_;
  JobSlot job_{parts_.queue, JobPriority::asked};
  EnvelopeChoice choice_;
  HandlePlaces places_;                // that were dragged
  QString dragged_;                    // the handle that was last
  Gesture choosing_;                   // until what was chosen is drawn
  QElapsedTimer begun_;                // the fit that runs
  std::optional<std::size_t> hovered_; // handle
  std::optional<Envelope> fitted_;
  const EnvelopeKind* fittedKind_ = nullptr; // of fitted_
  std::optional<Envelope> drawn_;            // the same with handles where they were dragged to
  bool isFresh_ = false;                     // of the plant and choice as they are
};

} // namespace espalier
