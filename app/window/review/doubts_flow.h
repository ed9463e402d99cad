#pragma once

#include "app/window/frame/scan_distances.h"
#include "app/window/frame/window_part.h"
#include "app/window/review/answered_doubts.h"
#include "core/doubt/expected_agreement.h"
#include "core/project/corrections.h"
#include "core/project/seal.h"
#include "core/skeleton/check_options.h"
#include "ui/jobs/job_slot.h"

#include <QTimer>

#include <functional>
#include <optional>
#include <set>
#include <vector>

namespace espalier {

class PlantDocument;

/// What is in doubt about the plant, and what was answered: found by a job, and a moment after an
/// edit that moves or attaches anything by another. Until that ends, what the edit has not touched
/// stays listed. Odds are as answers have taught. Nothing is found while nobody wants it.
class DoubtsFlow : public WindowPart {
  Q_OBJECT

public:
  /// All must outlive it.
  struct Parts {
    PlantDocument& document;
    JobQueue& queue;
    ScanDistances& distances;
    std::function<CheckOptions()> limits; // of the checks
    std::function<QString()> reviewer;
    std::function<void(const std::string&)> writeNow; // of what a project keeps, by its name
  };
  explicit DoubtsFlow(const Parts& parts);

  enum class Use : std::uint8_t { panel, asking };
  void setWanted(Use use, bool isWanted);

  /// Those that are to be asked, by their gain as learned.
  [[nodiscard]] const std::vector<Doubt>& doubts() const { return doubts_; }
  /// Likewise those that are ignored, and missing branches that are said to be none.
  [[nodiscard]] const std::vector<Doubt>& ignored() const { return ignored_; }
  /// Whether an answer that holds is that no branch is along the points of a finding.
  [[nodiscard]] bool isLeftOut(const Finding& finding) const;
  void ignore(const Doubt& doubt); // it is not asked until it is ignored no more
  /// Likewise if it was said to be none. @return what left it out, for restore()
  std::vector<AnsweredDoubt> stopIgnoring(const Doubt& doubt);
  void restore(const std::vector<AnsweredDoubt>& taken);
  [[nodiscard]] bool isKnown() const { return ratings_.has_value(); } // they were found once
  /// Those of the plant as it is are being found.
  [[nodiscard]] bool isBusy() const override;
  /// Why those of the plant as it is were not found; empty: nothing went wrong.
  [[nodiscard]] const QString& failure() const { return failure_; }
  void findAgain(); // after a failure
  void findAnew();  // limits of the checks are others; those of before stay listed meanwhile
  /// Whether the points of the scan are apart, so that something may follow from them.
  [[nodiscard]] bool hasSpacing() const;
  /// What of the plant is right, as the odds say; none: it is not known.
  [[nodiscard]] std::optional<ExpectedAgreement> expected() const;
  /// As answersFor(). pre: isKnown()
  [[nodiscard]] std::size_t answersFor(double share) const;
  /// Whether it is still to be asked, as it is or, of a missing branch, as it would be now.
  [[nodiscard]] bool isListed(const Doubt& doubt) const;

  /// Makes the plant what an alternative says, as one undo step, and learns from it.
  /// @throws Error if it is refused
  void answer(const Doubt& doubt, std::size_t alternative);
  /// None of the alternatives is right: the wood is marked doubtful; where a branch is missing, the
  /// node that would bear it. @throws Error likewise
  void answerNone(const Doubt& doubt);
  /// What an answer to it teaches: to be asked for while it is listed.
  [[nodiscard]] LearnedAnswer learnedOf(const Doubt& doubt) const;
  /// An edit by hand, the step done last, has answered it.
  void takeEdit(const Doubt& doubt, LearnedAnswer learned, bool wasWrong);
  [[nodiscard]] bool isAnswered(const Doubt& doubt) const;
  /// How many answers hold, and how many doubts are to be asked, if they were found.
  [[nodiscard]] SealedQuestions questions() const;
  /// Takes back the last answer that still holds, the doubt of which is asked again.
  /// @throws Error if there is none, or if other edits were made since
  AnsweredDoubt takeBack();
  /// Those by which decideRest() would change the plant. O(N + doubts)
  [[nodiscard]] std::vector<Doubt> decidedByOdds() const;
  /// As decideByOdds(), as one undo step. @return how many doubts changed the plant
  std::size_t decideRest();

signals:
  void changed();

private:
  struct FoundDoubts {
    std::vector<Doubt> doubts;
    ErrorRatings ratings;
  };
  void take(const SkeletonDelta& delta);
  void outdate();
  void dropAll();
  void refresh();
  void list();
  void note(const Doubt& doubt, LearnedAnswer learned, bool wasWrong, StepId step);
  void note(AnsweredDoubt answered, const Doubt& doubt);
  void keepAnswers(); // on the disk, at once
  [[nodiscard]] StepId editAs(const QString& text,
                              const std::function<void(SkeletonEditor&)>& change);
  [[nodiscard]] bool holds(const AnsweredDoubt& answered) const;
  void learnAnew();
  [[nodiscard]] ErrorRatings ratingsNow() const; // pre: isKnown()

  Parts parts_;
  QTimer timer_;
  std::set<Use> uses_;
  std::vector<Doubt> found_; // with odds as they were fitted
  std::vector<Doubt> doubts_;
  std::vector<Doubt> ignored_;
  std::optional<ErrorRatings> ratings_;
  MadeByHand byHand_; // of the skeleton whose doubts were listed last
  LearnedOdds learned_;
  std::vector<AnsweredDoubt> answered_; // also those whose step is undone, which may be redone
  std::vector<AnsweredDoubt> held_;     // those that hold
  bool isOutdated_ = true;              // they are not of the plant as it is
  int changes_ = 0;                     // of it
  bool isReplaced_ = false;             // the plant that a job is about, and it was stopped
  QString failure_;
  JobSlot job_;
};

} // namespace espalier
