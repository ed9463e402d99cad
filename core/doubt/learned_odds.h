#pragma once

#include "core/doubt/doubt.h"

#include <array>
#include <vector>

namespace espalier {

/// An answer, as odds are learned from it.
struct LearnedAnswer {
  Doubt::Kind kind = Doubt::Kind::end;
  double said = 0;       // in (0, 1): how probably the plant was wrong there, as fitted
  double spacings = 0;   // long the wood in doubt is; where there is no spacing, as is usual
  bool wasWrong = false; // the plant, as it was

  bool operator==(const LearnedAnswer&) const = default;
};

/// What the answers about a plant say of the odds that were fitted on others: an expert may leave
/// out twigs, or draw them all.
///
/// For each kind of doubt the logarithm of the odds that the plant is wrong is moved by a constant,
/// and by the logarithm of how long the wood is times another: those that are the most probable
/// after the answers, where both were normal about 0 before, with deviations of 1 and 0.5. Without
/// answers nothing is moved; a doubt may be asked about for the first time only, so that none
/// counts twice.
class LearnedOdds {
public:
  LearnedOdds() = default;
  explicit LearnedOdds(std::vector<LearnedAnswer> answers); // O(answers)

  void learn(const LearnedAnswer& answer); // O(answers)
  [[nodiscard]] const std::vector<LearnedAnswer>& answers() const { return answers_; }

  /// The doubts with odds as they are learned, by their gain anew.
  /// @param doubts  with odds as they were fitted
  /// @param spacing of the points [L]; 0: none is known, and all wood counts as of usual length
  [[nodiscard]] std::vector<Doubt> adjusted(std::vector<Doubt> doubts, double spacing) const;

private:
  struct Moved {
    double constant = 0;
    double perLength = 0;
  };
  void fit(Doubt::Kind kind);

  std::vector<LearnedAnswer> answers_;
  std::array<Moved, doubtKinds> moved_;
};

/// What an answer teaches; the spacing as in adjusted(). pre: the odds of the doubt are as they
/// were fitted
[[nodiscard]] LearnedAnswer learnedFrom(const Doubt& doubt, bool wasWrong, double spacing);

} // namespace espalier
