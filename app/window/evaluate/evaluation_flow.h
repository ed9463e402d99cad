#pragma once

#include "app/window/evaluate/edit_choices.h"
#include "app/window/evaluate/error_walk.h"
#include "app/window/evaluate/methods_flow.h"
#include "app/window/evaluate/reference_flow.h"
#include "app/window/evaluate/report_flow.h"
#include "app/window/evaluate/traits_flow.h"
#include "app/window/frame/panel_dock.h"
#include "app/window/frame/window_part.h"
#include "core/evaluate/evaluation.h"
#include "ui/document/plant_document.h"
#include "ui/jobs/job_slot.h"

#include <QTimer>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class QMenu;

namespace espalier {

class EvaluationPanel;
class IgnoringSteps;
class PlotView;
struct EvaluationText;

/// The evaluation dock: without a reference the traits of the plant by itself; with one, it
/// compares the plant with that, as a job a moment after each edit, and shows scores, curve and
/// errors, and both skeletons in the colors of what differs.
///
/// Nothing is compared while nobody looks. What is shown after an edit is pale until it is fresh.
class EvaluationFlow : public WindowPart {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    PlantDocument& document;
    PlantView& view;
    JobSlot& jobs;
    Editing& editing;
    ReferenceFlow& reference;
    IgnoringSteps& ignoring;
    PanelDock::Parts window;
  };
  explicit EvaluationFlow(const Parts& parts);
  ~EvaluationFlow() override;

  void setPlantShown(bool isShown) override;
  void setChoices(std::vector<ChoiceRecord> records); // for the report
  /// Of a run that the plant is now from, for the report; none: not known. The reference is laid
  /// anew.
  void setMade(std::optional<PipelineOptions> options);
  void setEnvelope(std::optional<ReportedEnvelope> envelope); // for the report of the plant
  void setDark(bool isDark);

  /// Null: nothing has been compared. Of the plant as it is, if isUpToDate().
  [[nodiscard]] const std::shared_ptr<const Evaluation>& evaluation() const { return evaluation_; }
  [[nodiscard]] bool isUpToDate() const { return isFresh_; }
  /// How a result is compared with the reference, as chosen.
  [[nodiscard]] EvaluationOptions options() const {
    return {.registers = isLaid_ && !parts_.reference.liesInPlace(),
            .turns = turns_,
            .up = parts_.document.up(),
            .motion = std::nullopt,
            .edit = edits_->options(),
            .tolerance = tolerance_,
            .breastHeight = breastHeightIn(symbol(parts_.document.unit()).toStdString())};
  }

signals:
  void changed(); // what a project keeps of it

private:
  void makePanel();
  void fillMenu(QMenu& menu) const;
  void keepTexts();
  /// How it is compared, as a project keeps it, and back.
  /// @throws Error if it is no such text; all is as at first then
  [[nodiscard]] std::string text() const;
  void show(const std::string& text);
  void connectDocument();
  void connectPanel();
  void take(const EvaluationText& chosen); // of all that is chosen here
  void takeReference();
  void takeIgnored(); // of the reference
  void showTraits();
  void letGoOfPlace(); // where the reference lies is found anew
  void takeEdit();
  void later();
  void start();
  void show(Evaluation evaluation);
  void forget();
  void setFresh(bool isFresh);
  void showColors();
  void setOptions(); // of all that compares
  void chooseTolerance(double tolerance);
  void chooseAnew(); // what is compared, or how
  void saveMapping();
  [[nodiscard]] bool isWanted() const;
  [[nodiscard]] EvaluationOptions optionsNow() const; // with what is known of the plant

  Parts parts_;
  std::unique_ptr<EditChoices> edits_;
  std::unique_ptr<QMenu> editsMenu_;
  std::unique_ptr<ErrorWalk> errors_;
  std::unique_ptr<MethodsFlow> methods_;
  std::unique_ptr<ReportFlow> report_;
  std::unique_ptr<TraitsFlow> traits_;
  EvaluationPanel* panel_ = nullptr;
  PlotView* plot_ = nullptr;
  PanelDock* dock_ = nullptr;
  QTimer timer_;
  JobSlot job_{parts_.jobs.queue(), JobPriority::asked};
  bool isOutdated_ = false; // while the job runs: it has to begin again
  bool isFresh_ = false;
  std::shared_ptr<const Evaluation> evaluation_;
  std::optional<Eigen::Isometry3d> motion_; // of the reference; none: to be found
  bool isEdited_ = false;                   // since then
  std::shared_ptr<const std::vector<double>>
      coverages_;         // of the reference there; null: to be found
  double tolerance_ = 0;  // [L], as chosen; 0: by the rule
  std::string reference_; // its key
  std::map<std::string, std::vector<DifferingPart>> ignoredOf_; // of others before, by theirs
  bool isLaid_ = true;
  bool turns_ = true;
};

} // namespace espalier
