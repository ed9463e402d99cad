#include "core/doubt/learned_odds.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace espalier {
namespace {

constexpr double usualLength = 20; // spacings

double logOdds(double probability) {
  constexpr double least = 1e-3; // nothing is surer
  const double kept = std::clamp(probability, least, 1 - least);
  return std::log(kept / (1 - kept));
}

double lengthTerm(double spacings) {
  return std::log((spacings + 1) / usualLength);
}

double spacingsOf(const Doubt& doubt, double spacing) {
  return spacing > 0 ? doubt.length / spacing : usualLength - 1;
}

double sigmoid(double value) {
  return 1 / (1 + std::exp(-value));
}

} // namespace

LearnedOdds::LearnedOdds(std::vector<LearnedAnswer> answers) : answers_(std::move(answers)) {
  for (int kind = 0; kind < doubtKinds; ++kind)
    fit(static_cast<Doubt::Kind>(kind));
}

void LearnedOdds::learn(const LearnedAnswer& answer) {
  answers_.push_back(answer);
  fit(answer.kind);
}

/// The most probable after the answers, by Newton's method.
void LearnedOdds::fit(Doubt::Kind kind) {
  const Eigen::Vector2d precision(1, 4); // of what was thought before
  Eigen::Vector2d found = Eigen::Vector2d::Zero();
  for (int step = 0; step < 50; ++step) {
    Eigen::Vector2d slope = -precision.cwiseProduct(found);
    Eigen::Matrix2d curvature = precision.asDiagonal();
    for (const LearnedAnswer& answer : answers_) {
      if (answer.kind != kind) continue;
      const Eigen::Vector2d terms(1, lengthTerm(answer.spacings));
      const double wrong = sigmoid(logOdds(answer.said) + terms.dot(found));
      slope += ((answer.wasWrong ? 1 : 0) - wrong) * terms;
      curvature += wrong * (1 - wrong) * terms * terms.transpose();
    }
    const Eigen::Vector2d change = curvature.ldlt().solve(slope);
    found += change;
    if (change.norm() < 1e-9) break;
  }
  moved_[static_cast<std::size_t>(kind)] = {found[0], found[1]};
}

std::vector<Doubt> LearnedOdds::adjusted(std::vector<Doubt> doubts, double spacing) const {
  for (Doubt& doubt : doubts) {
    const Moved& moved = moved_[static_cast<std::size_t>(doubt.kind)];
    const double said = doubt.wrong();
    const double wrong = sigmoid(logOdds(said) + moved.constant +
                                 moved.perLength * lengthTerm(spacingsOf(doubt, spacing)));
    for (std::size_t i = 0; i < doubt.alternatives.size(); ++i)
      doubt.alternatives[i].probability =
          i == doubt.present ? 1 - wrong : doubt.alternatives[i].probability * wrong / said;
    doubt.gain *= wrong / said;
    const Alternative present = doubt.alternatives[doubt.present];
    std::ranges::stable_sort(doubt.alternatives, std::greater(), &Alternative::probability);
    doubt.present = static_cast<std::size_t>(
        std::ranges::find(doubt.alternatives, present.kind, &Alternative::kind) -
        doubt.alternatives.begin());
  }
  std::ranges::stable_sort(doubts, std::greater(), &Doubt::gain);
  return doubts;
}

LearnedAnswer learnedFrom(const Doubt& doubt, bool wasWrong, double spacing) {
  return {.kind = doubt.kind,
          .said = doubt.wrong(),
          .spacings = spacingsOf(doubt, spacing),
          .wasWrong = wasWrong};
}

} // namespace espalier
