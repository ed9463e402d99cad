#pragma once

#include "core/project/corrections.h"
#include "core/project/review_record.h"
#include "core/skeleton/skeleton.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace espalier {

/// How a structure agrees with another, by scores of evaluation (core/evaluate/scores.h).
struct SealedAgreement {
  std::string with;                        // name of the other
  double distance = 0;                     // [L], what is called near
  double precision = 0, recall = 0, f = 0; // 0 where no length is near
  std::optional<double> structural = {};   // T; none: no segments match

  bool operator==(const SealedAgreement&) const = default;
};

/// Questions about what was in doubt, which the program asks.
struct SealedQuestions {
  std::size_t answered = 0;             // by answers that held
  std::optional<std::size_t> open = {}; // none: what is in doubt was not sought

  bool operator==(const SealedQuestions&) const = default;
};

/// What stood against a structure, and what spoke for it, when it was signed.
struct SealedState {
  std::map<std::string, std::size_t> findings; // that were open, by the names of their kinds
  std::size_t ignored = 0;                     // findings that were looked at and ignored
  std::size_t points = 0;                      // in use of the scan; 0: there was none
  std::size_t unexplained = 0;                 // of these, farther from the wood than checks allow
  std::size_t ignoredPlaces = 0;               // of the ignored findings, those of such points
  std::size_t ignoredPoints = 0;               // of the unexplained ones, those at these places
  std::optional<SealedQuestions> questions;    // none: it was signed by an older program
  std::optional<SealedAgreement> automatic;    // with what the program found, or was opened
  std::optional<SealedAgreement> other;        // with the reference that was loaded
  std::string reason;                          // why it was signed though findings were open

  [[nodiscard]] std::size_t openFindings() const; // of all kinds
  bool operator==(const SealedState&) const = default;
};

/// An expert's word that a structure is right: who signed it, when, and what work went into it.
/// It holds for the structure it was given for, and for no other.
struct Seal {
  std::string author;
  std::int64_t time = 0; // [ms] since 1970-01-01 UTC
  HandWork work;
  std::size_t nodes = 0;
  double length = 0;                  // [L] of all edges
  std::uint64_t hash = 0;             // StructureHash of what was signed
  std::optional<ReviewRecord> review; // none, as of `state`: it was signed by an older program
  std::optional<SealedState> state;

  /// Whether all was marked in steps of no more than one looks at in one go.
  [[nodiscard]] bool isAllLookedAt() const {
    return review && review->inBulk.nodes == 0 && review->before.nodes == 0;
  }

  bool operator==(const Seal&) const = default;
};

/// @param time  now [ms] since 1970-01-01 UTC
/// @throws Error if a node is not reviewed, there is none, or `author` is blank
[[nodiscard]] Seal signedBy(const std::string& author, std::int64_t time, const History& history,
                            std::optional<SealedState> state = {});

/// A JSON object with keys in snake_case, for projects and for a file beside an exported structure.
[[nodiscard]] std::string textOf(const Seal& seal);
/// @throws Error if the text is none of a seal
[[nodiscard]] Seal sealFrom(const std::string& text);

} // namespace espalier
