#pragma once

#include "app/window/frame/reveal.h"
#include "app/window/frame/window_part.h"
#include "app/window/review/doubts_flow.h"

#include <QKeySequence>
#include <QList>
#include <QPointer>
#include <QTimer>

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

class QAction;
class QMainWindow;
class QSettings;

namespace espalier {

class ActionSet;
class DoubtsPanel;
class Editing;
class PanelDock;
class PlantView;

/// Asks about what is in doubt, what matters most first: flies to where the alternatives are seen
/// apart, draws them with their numbers, and takes the answer by one key. An answer is one undo
/// step. Any edit of the wood that is asked about answers, too.
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
    QSettings& settings;
    QMainWindow& window;
    Reveal reveal;
  };
  explicit AskingFlow(Parts parts);

  void setEnabled(bool isEnabled) override;
  [[nodiscard]] QString hint() const override;
  /// Something is asked, or is shown to be decided: stopAsking() ends it.
  [[nodiscard]] bool isShowing() const { return isAsking_ || isRestShown_; }
  void stopAsking();

private:
  static constexpr std::size_t mostListed = 200; // doubts, that a person looks at

  void addActions();
  void makePanel();
  void connectParts();
  void begin(const std::optional<Doubt>& first = {}); // none: what matters most
  void borrowKeys();
  void giveKeysBack();
  void goOn(); // to the next doubt
  void goTo(const Doubt& doubt);
  void fly();
  void draw();
  void answer(std::size_t alternative);
  void answerNone();
  void skip();
  void takeBack();
  void decideRest();
  void wait();
  void followDoubts();
  void askAgain(); // what was to be corrected by hand, once that is undone
  void noteEdit(const SkeletonDelta& delta);
  void takeEdit();
  /// Whether the wood that is asked about is gone, for the most part, or grows from other wood now.
  [[nodiscard]] bool isMadeOtherwise() const;
  [[nodiscard]] StepId lastStep() const; // that is done; 0: none
  void refreshPanel();
  void refreshEnabled();
  [[nodiscard]] QString agreementText() const;
  [[nodiscard]] QString noteText() const;
  [[nodiscard]] bool isSkipped(const Doubt& doubt) const;

  Parts parts_;
  DoubtsPanel* panel_ = nullptr;
  PanelDock* dock_ = nullptr;
  QList<QAction*> answers_; // by alternative
  QList<QAction*> keys_;    // on while it asks
  std::vector<std::pair<QPointer<QAction>, QList<QKeySequence>>> borrowed_;
  std::optional<Doubt> current_;
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
  bool isWoodEdited_ = false; // that is asked about, rather than what an alternative refers to
  QTimer editEnds_;           // runs while wood that is asked about is edited by hand
  QTimer panelTimer_;
  bool isRestShown_ = false; // what the odds would decide: the same action makes it
  QString agreement_;        // as it was known last
  bool isEnabled_ = true;
};

} // namespace espalier
