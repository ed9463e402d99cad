#pragma once

#include "app/window/frame/reveal.h"
#include "app/window/frame/scan_distances.h"
#include "app/window/frame/window_part.h"
#include "app/window/review/doubts_flow.h"
#include "core/skeleton/finding.h"
#include "ui/panels/suspects_model.h"

#include <QTimer>

#include <functional>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

class QMainWindow;
class QSettings;

namespace espalier {

class ActionSet;
class AskingFlow;
class FindingsFlow;
class IgnoringSteps;
class PanelDock;
class PlantView;
class SuspectsPanel;

/// All that may be wrong with the plant, in one list: findings of the checks and doubts, what a
/// look probably puts most right first. The walk from one to the next, what is ignored, and which
/// of them are listed.
class SuspectsFlow : public WindowPart {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    PlantDocument& document;
    PlantView& view;
    ActionSet& actions;
    ScanDistances& distances;
    FindingsFlow& findings;
    DoubtsFlow& doubts;
    AskingFlow& asking;
    QSettings& settings;
    QMainWindow& window;
    Reveal reveal;
    std::function<void()> actOnSelected; // keys, whatever the pointer is on, until it moves
    IgnoringSteps& ignoring;
  };
  explicit SuspectsFlow(Parts parts);

private:
  using What = std::variant<Finding, Doubt>;

  [[nodiscard]] bool showsIgnored() const; // and nothing else
  void addActions();
  void makePanel();
  void connectParts();
  void refresh();
  [[nodiscard]] std::vector<Suspect> suspects(bool areIgnored) const;
  void findTwins();
  [[nodiscard]] bool isIgnoredAsDoubt(std::size_t finding) const;
  [[nodiscard]] std::optional<std::size_t> listedTwin(std::size_t finding) const;
  [[nodiscard]] std::optional<std::size_t> findingAbout(std::size_t doubt) const;
  [[nodiscard]] bool isListedPlace(const std::vector<NodeId>& nodes) const;
  [[nodiscard]] bool isListed(const Doubt& doubt) const;
  void showKinds(const std::vector<Suspect>& all, std::size_t ignored);
  [[nodiscard]] const Finding& findingOf(const Suspect& suspect) const;
  [[nodiscard]] const Doubt& doubtOf(const Suspect& suspect) const;
  [[nodiscard]] What whatOf(const Suspect& suspect) const;
  [[nodiscard]] bool isSame(const Suspect& one, const What& what) const;
  [[nodiscard]] std::optional<std::size_t> rowOf(const What& what) const;
  [[nodiscard]] std::size_t rowFrom(int by) const;
  void keepPlace();

  [[nodiscard]] bool isSearching() const;
  void step(int by);
  void noteNothing();
  void answer();
  void choose(std::size_t row);
  void goTo(const Finding& finding);
  void leaveFinding();
  void showAsked(const std::optional<Doubt>& doubt, bool isByHand);
  void toggleIgnored();
  void ignore(const What& what, const std::vector<AnsweredDoubt>& as = {});
  std::vector<AnsweredDoubt> showAgain(const What& what);
  void bringBack(const What& what);
  void showAction();
  void selectAll();
  enum class Listed : std::uint8_t { all, inView, selected, axes };
  void listOnly(Listed listed);

  [[nodiscard]] double spacing() const; // between points [L]; 0: there is no scan
  [[nodiscard]] SuspectText textOf(const Suspect& suspect) const;
  [[nodiscard]] QString placeText(const Finding& finding) const;
  [[nodiscard]] QString describedBy(const Finding& finding) const;
  [[nodiscard]] QString sentenceOf(const Finding& finding) const;
  [[nodiscard]] QString sentenceOf(const What& what) const;
  [[nodiscard]] QString titleText() const;
  [[nodiscard]] QString noteText() const;
  [[nodiscard]] QString agreementText() const;
  void refreshTexts();
  void refreshAgreement();

  Parts parts_;
  SuspectsPanel* panel_ = nullptr;
  PanelDock* dock_ = nullptr;
  QTimer agreementTimer_;
  QString agreement_;                       // as it was known last
  std::size_t count_ = 0;                   // of all, whatever is listed
  std::size_t ignoredCount_ = 0;            // in the part that is listed
  std::shared_ptr<const PointCloud> cloud_; // that points of findings are in
  /// Of each finding, the doubt about the same points: its number, behind those that are not
  /// ignored those that are.
  std::vector<std::optional<std::size_t>> twins_;
  int kind_;                    // that is listed
  Listed listed_ = Listed::all; // of the plant
  std::vector<bool> isIn_;      // by id, what is listed of it; nodes that are newer are
  std::optional<What> current_;
  std::vector<NodeId> nodesOfFinding_; // that were selected where it was gone to
  PointSet pointsOfFinding_;           // likewise
  struct Place {
    std::size_t row;
    double gain;
  };
  std::optional<Place> place_; // in the list, of what was current last
  bool isRefreshing_ = false;
  bool isAwaited_ = false; // one has asked for one before there were any
  int awaitedStep_ = 0;    // where to then: as of step(); 0: one only waits for the result
  bool wasWhole_ = false;  // all that may be wrong was known once since the list is shown
};

} // namespace espalier
