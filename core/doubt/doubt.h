#pragma once

#include "core/pipeline/attach_grown.h"
#include "core/skeleton/skeleton_delta.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace espalier {

/// One of the answers that a doubt may have: what the plant would be like there.
struct Alternative {
  enum class Kind : std::uint8_t {
    asItIs, // nothing changes
    remove, // the wood is none: it goes, with all that it carries
    attach, // the wood grows from another node
    add     // there is a branch, where points have none
  };
  Kind kind = Kind::asItIs;
  double probability = 0;                 // in (0, 1)
  std::optional<NodeId> onto = {};        // to attach the wood to
  std::optional<GrownBranch> branch = {}; // to add
};

/// A place where it is not sure how the plant is, with what it may be like.
struct Doubt {
  enum class Kind : std::uint8_t {
    end,        // is this wood, or does noise, a leaf or bark look like it?
    attachment, // what does it grow from?
    missing     // is there a branch, where points have none?
  };
  Kind kind = Kind::end;
  NodeId node{}; // the lowest of the wood in doubt; where a branch is missing: what would bear it
  std::vector<NodeId> nodes = {};             // of that wood, an unbranched run, `node` first
  std::vector<Alternative> alternatives = {}; // the most probable first, 2 to 4
  std::size_t present = 0;                    // which of them is as it is
  double length = 0;                          // [L] of the wood in doubt, or that is missing
  double gain = 0; // how much of the plant an answer probably puts right: of length and ends, in
                   // the mean, a share in [0, 1]

  [[nodiscard]] double wrong() const { return 1 - alternatives[present].probability; }
};

inline constexpr int doubtKinds = 3;

/// "end", "attachment", "missing"
[[nodiscard]] std::string nameOf(Doubt::Kind kind);
/// "as_it_is", "remove", "attach", "add"
[[nodiscard]] std::string nameOf(Alternative::Kind kind);

/// Where the branch that one of its alternatives adds begins and ends [L]; none: none adds one.
[[nodiscard]] std::optional<std::pair<Eigen::Vector3d, Eigen::Vector3d>>
endsOfAdded(const Doubt& doubt);

/// Are two doubts, before and after some edit, one to a person? Those about the same wood, and
/// about branches that would begin and end at the same places within `near` [L].
[[nodiscard]] bool isSame(const Doubt& a, const Doubt& b, double near);

/// Whether all that a doubt refers to is still there, and wood that may go carries nothing else.
[[nodiscard]] bool isThere(const Doubt& doubt, const Skeleton& skeleton);

/// Makes the plant what an alternative says, and marks the wood that it settles as reviewed.
/// @param reviewer  whose answer it is; none: the marks stay
/// @throws Error if it is refused; nothing has changed then
/// pre: isThere(doubt, editor.skeleton())
void settle(SkeletonEditor& editor, const Doubt& doubt, const Alternative& alternative,
            const std::optional<std::string>& reviewer);

/// How probable something else than the present is that is decided unasked. Without answers that
/// taught otherwise, less made some of ten simulated plants and the pine of the thesis worse.
inline constexpr double surelyOtherwise = 0.8;

/// Makes the plant as its doubts would be decided by their odds: where something else than the
/// present is the most probable, and by `least` or more, that. Of the ends at one foot one stays.
/// Nothing is marked.
/// @param least  in [0, 1]
/// @return those that changed it, by their number, ascending; what other changes have made void is
/// passed over
std::vector<std::size_t> decideByOdds(SkeletonEditor& editor, const std::vector<Doubt>& doubts,
                                      double least = surelyOtherwise);

} // namespace espalier
