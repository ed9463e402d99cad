#pragma once

#include "app/window/frame/reveal.h"
#include "app/window/frame/window_part.h"
#include "core/skeleton/review_stops.h"

#include <QList>
#include <QString>
#include <QTimer>

#include <functional>
#include <optional>
#include <utility>
#include <vector>

class QAction;
class QMainWindow;
class QSettings;

namespace espalier {

class ActionSet;
class Editing;
class ExpectedErrorsFlow;
class IgnoringSteps;
class PanelDock;
class PlantDocument;
class PlantView;
class ReviewPanel;

/// The review: the walk along the plant, the marks on what is selected, and the panel for both.
///
/// The walk goes from stop to stop (core/skeleton/review_stops.h), along the plant or by expected
/// error. The stop one is at is what is selected; so it can be changed by any selection before it
/// is marked. At points without wood, which are selected as points, Enter leaves them out of the
/// findings. The key that marks it reviewed does so only with what is seen and is looked at in one
/// go (app/window/review/looked_at.h): what is not seen it shows first. It takes no doubt back
/// unasked, and leads to none.
class ReviewFlow : public WindowPart {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    PlantDocument& document;
    PlantView& view;
    ActionSet& actions;
    Editing& editing;
    QSettings& settings;
    QMainWindow& window;
    Reveal reveal;
    std::function<const std::vector<NodeId>&()> hidden; // in order
    ExpectedErrorsFlow& errors;
    std::function<bool(const Finding&)> isIgnored; // of points without wood: they are looked at
    std::function<void(const Finding&, bool)> setIgnored;
    IgnoringSteps& ignoring;
    std::function<bool()> looksAtQuestion; // that is up: no stop is marked, one looks there again
  };
  /// @param sign  the action that the panel offers at its foot
  ReviewFlow(const Parts& parts, QAction* sign);

  void setEnabled(bool isEnabled) override;
  void setEnterTaken(bool isTaken); // by a tool: Enter marks nothing then, but the keys beside it
  void setInGesture(bool isInGesture); // of a tool: Enter is its own then, and nothing is marked

  [[nodiscard]] ReviewPanel& panel() { return *panel_; }
  [[nodiscard]] const QString& reviewer() const { return reviewer_; }
  void setReviewer(const QString& name);

signals:
  void reviewerChanged(const QString& name);

private:
  void addWalkActions();
  void addMarkActions();
  void makePanel(QAction* sign);
  void connectParts();
  bool eventFilter(QObject* watched, QEvent* event) override;

  [[nodiscard]] std::vector<ReviewStop> stops() const;
  [[nodiscard]] std::optional<std::size_t> placeIn(const std::vector<ReviewStop>& all) const;
  void step(WalkTo to, WalkDirection direction = WalkDirection::forward);
  bool stepIfAny(WalkTo to, WalkDirection direction = WalkDirection::forward);
  void goOnWaiting();
  void chooseOrder(bool isByError);
  void goTo(const std::vector<ReviewStop>& all, std::size_t index);
  void describe(const std::vector<ReviewStop>& all, const ReviewStop& stop);
  void describeAgain();
  [[nodiscard]] QString whyRisky(const ReviewStop& stop) const;
  void goToPoints(const ReviewStop& stop);
  [[nodiscard]] QString frame(const std::vector<NodeId>& nodes,
                              const std::vector<Eigen::Vector3d>& places = {});
  [[nodiscard]] std::vector<Eigen::Vector3d> placesAt() const; // of the points one is at
  [[nodiscard]] bool isAtPoints() const;
  void takePoints();
  void bringBack(const std::vector<Finding>& points); // that were taken
  void markReviewed();
  void markDoubtful();
  void goOnAfter(bool wasDoubtful);
  void markAllSelected();
  [[nodiscard]] std::vector<NodeId> selected(ReviewState state) const;
  void askForDoubt(const std::vector<NodeId>& doubtful);
  void mark(ReviewState state, const std::vector<NodeId>& nodes);
  void comment(const QString& text);
  void beginComment();
  void requireChosen(const QString& why) const;
  void requireToMark() const;
  void showPlace();
  [[nodiscard]] QString leftText(const std::vector<ReviewStop>& all) const;
  void refreshEnabled();

  Parts parts_;
  ReviewPanel* panel_ = nullptr;
  PanelDock* dock_ = nullptr;
  QList<QAction*> walks_;
  QList<QAction*> marks_;
  QString reviewer_;
  std::vector<NodeId> at_;        // where one is; may hold nodes that are gone
  std::vector<Finding> atPoints_; // clusters of points, and at_ has the node near them
  std::vector<Finding> doubted_;  // points that are doubtful, until the program ends
  WalkOrder order_ = WalkOrder::alongPlant;
  std::optional<std::pair<WalkTo, WalkDirection>> awaited_; // once errors are known
  QString placeText_;                                       // of at_
  QString whyText_;                                         // likewise
  QTimer again_;                 // describes the stop once an edit is over
  bool isDoubtAskedFor_ = false; // of what is selected: Enter takes it back
  bool isFading_ = false;        // all but at_, while it is what is selected
  bool isEnabled_ = true;
  bool isInGesture_ = false;
  bool isEnterTaken_ = false;
};

} // namespace espalier
