#pragma once

#include "core/doubt/learned_odds.h"
#include "core/project/history.h"
#include "core/skeleton/finding.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace espalier {

/// A doubt that was answered: it is not asked again, and its answer is learned from. Or one that is
/// ignored: it is not asked again, and nothing is learned.
struct AnsweredDoubt {
  Doubt::Kind kind = Doubt::Kind::end;
  NodeId node{};                                 // as of the doubt
  Eigen::Vector3d tip = Eigen::Vector3d::Zero(); // of a branch that would be added [L]
  std::optional<Eigen::Vector3d> foot = {};      // of that; none: older projects do not have it
  /// Its box: the least and the greatest coordinates of its nodes. None: likewise.
  std::optional<std::array<Eigen::Vector3d, 2>> box = {};
  LearnedAnswer learned = {}; // of the same kind
  StepId step = {};           // that made the answer; 0: it changed nothing
  bool isIgnored = false;

  bool operator==(const AnsweredDoubt&) const = default;
};

/// Whether an answer is about a doubt; of branches that would be added, one whose foot and tip are
/// within `near` [L].
[[nodiscard]] bool isAbout(const AnsweredDoubt& answered, const Doubt& doubt, double near);

/// Whether its doubt is listed as ignored: it is, or the answer is that points without wood need
/// none.
[[nodiscard]] bool leavesOut(const AnsweredDoubt& answered);

/// Whether the points of a finding are those of a branch that an answer is about: their middle lies
/// in its box, and they reach no farther than that is wide, each but for one spacing [L]. False of
/// any other finding, and of answers that know no box.
[[nodiscard]] bool isAbout(const AnsweredDoubt& answered, const Finding& finding, double spacing);

/// Answers as a project keeps them: [{"kind": "end", "node": 12, "said": 0.4, "spacings": 8.5,
/// "wrong": true, "step": "31"}]; of what is missing with "tip" and "foot": [x, y, z] and "box":
/// two of these, of what is ignored with "ignored": true. Empty: none.
[[nodiscard]] std::string textOf(const std::vector<AnsweredDoubt>& answered);

/// Of an empty text, none.
/// @throws Error if it is no such text
[[nodiscard]] std::vector<AnsweredDoubt> answeredFrom(const std::string& text);

} // namespace espalier
