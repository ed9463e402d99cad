#pragma once

#include "app/window/frame/reveal.h"
#include "app/window/frame/window_part.h"
#include "app/window/review/doubts_flow.h"

#include <QElapsedTimer>
#include <QKeySequence>
#include <QList>
#include <QPointer>
#include <QTimer>

#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

class QAction;
class QMainWindow;

namespace espalier {

class ActionSet;
class Editing;
class PlantView;

/// Asks about what is in doubt, what matters most first: flies to where the alternatives are seen
/// apart, draws them with their numbers, and takes the answer by one key. An answer is one undo
/// step. Any edit of the wood that is asked about answers, too. A key that comes before a question
/// is drawn does not answer it.
///
/// While it asks, the keys 0 to 4, Space and Backspace are its own.
class AskingFlow : public WindowPart {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    PlantDocument& document;
    PlantView& view;
    ActionSet& actions;
    Editing& editing;
    DoubtsFlow& doubts;
    ScanDistances& distances;
    QMainWindow& window;
    Reveal reveal;
  };
  explicit AskingFlow(Parts parts);

  void setEnabled(bool isEnabled) override;
  [[nodiscard]] QString hint() const override;
  /// Something is asked, or is shown to be decided: stopAsking() ends it.
  [[nodiscard]] bool isShowing() const { return isAsking_ || isRestShown_; }
  [[nodiscard]] bool isRestShown() const { return isRestShown_; } // to be decided
  void askAbout(const Doubt& doubt); // where it may not ask, it only goes there
  void stopAsking();
  /// Shows the question again, from wherever one looks. @return whether there is one
  bool lookAgain();
  /// Which doubts it goes through by itself; at first all.
  void askOnlyAbout(std::function<bool(const Doubt&)> isAskedAbout);
  /// Goes on or ends once other doubts are found or one is settled; after what lists them.
  void followDoubts();
  [[nodiscard]] QString failureText() const; // of the search for doubts

signals:
  void begun();
  /// @param isByHand no alternative was right: it is corrected with a tool
  void asked(const std::optional<espalier::Doubt>& doubt, bool isByHand); // none: nothing is

private:
  void addActions();
  void connectParts();
  void begin(const std::optional<Doubt>& first = {}); // none: what matters most
  void borrowKeys();
  void giveKeysBack();
  void giveSelectionBack();
  void goOn(); // to the next doubt
  void goTo(const Doubt& doubt);
  void look(const Doubt& doubt);
  void draw();
  [[nodiscard]] bool requireDrawn(); // the question; else says so, and is there at once
  void answer(std::size_t number);   // of an alternative, from 0 on
  void answerNone();
  void skip();
  void takeBack();
  void decideRest();
  void wait();
  void askAgain(); // what was to be corrected by hand, once that is undone
  void noteEdit(const SkeletonDelta& delta);
  void takeEdit();
  /// Whether the wood that is asked about is gone, for the most part, or grows from other wood now.
  [[nodiscard]] bool isMadeOtherwise() const;
  void refreshEnabled();
  [[nodiscard]] bool isSkipped(const Doubt& doubt) const;

  Parts parts_;
  std::function<bool(const Doubt&)> isAskedAbout_ = [](const Doubt&) { return true; };
  QList<QAction*> answers_; // by their numbers
  QList<QAction*> keys_;    // on while it asks
  std::vector<std::pair<QPointer<QAction>, QList<QKeySequence>>> borrowed_;
  std::vector<NodeId> selectedBefore_; // when it began
  std::vector<NodeId> selectedByIt_;
  std::optional<Doubt> current_;
  QElapsedTimer sinceAsked_;
  int framesBefore_ = 0;       // the view was drawn at rest when it was asked
  LearnedAnswer taught_;       // by an answer to it
  StepId stepBefore_ = {};     // done when it was asked
  std::optional<NodeId> foot_; // of its wood then
  std::size_t idEnd_ = 0;      // of the plant then
  std::vector<Doubt> skipped_; // asked once all others are
  std::vector<Doubt> asked_;   // that were answered, the last at the back
  bool isAsking_ = false;
  bool isAwaited_ = false; // it begins once doubts are known
  bool isByHand_ = false;  // none of the alternatives was right: an edit is waited for
  bool isOwnEdit_ = false;
  bool isEdited_ = false;     // by hand, while one question was up
  bool isWoodEdited_ = false; // that is asked about, rather than what an alternative refers to
  QTimer editEnds_;           // runs while wood that is asked about is edited by hand
  bool isRestShown_ = false;  // what the odds would decide: the same action makes it
  bool isEnabled_ = true;
};

} // namespace espalier
