#pragma once

#include "core/doubt/expected_agreement.h"
#include "core/doubt/find_doubts.h"
#include "core/doubt/learned_odds.h"
#include "core/doubt/oracle.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace espalier {

/// In which order doubts are asked about.
enum class AskingOrder : std::uint8_t {
  byGain,    // what probably puts most right first
  random,    // any
  alongPlant // as a review walks: the trunk, then each branch with what it carries
};

/// The program asks about a plant, and an expert answers who has a reference: what answers are
/// worth is measured so.
class Interview {
public:
  struct Options {
    double tolerance = 0; // [L] how far from the reference is near, > 0
    AskingOrder order = AskingOrder::byGain;
    std::uint64_t seed = 1; // of the random order
    bool learns = true;     // from answers, about this plant
  };

  /// @param plant     reconstructed from `cloud`, with radii, in its frame
  /// @param reference where the plant is
  /// @param scale     of the plant; its spacing is > 0
  /// @param up        length 1
  /// @throws Cancelled if `progress` asks to stop; Error as agreementWith()
  Interview(std::shared_ptr<const PointCloud> cloud, Skeleton plant, Skeleton reference,
            const PlantScale& scale, Eigen::Vector3d up, const Options& options,
            const Progress& progress = {});

  Interview(const Interview&) = delete; // the oracle refers to the reference
  Interview& operator=(const Interview&) = delete;

  /// Asks about one doubt, and makes the plant what is answered. False: nothing is in doubt.
  bool askNext(const Progress& progress = {});

  /// Decides all that is still in doubt by the odds as they are learned (decideByOdds()).
  void decideRest(const Progress& progress = {});

  [[nodiscard]] const Skeleton& plant() const { return plant_; }
  [[nodiscard]] const Skeleton& reference() const { return reference_; }
  [[nodiscard]] std::size_t answers() const { return answered_.size(); }
  /// Answers that were not "as it is", and what decideRest() decided otherwise than it was.
  [[nodiscard]] std::size_t changes() const { return changes_; }
  [[nodiscard]] const std::vector<Doubt>& doubts() const { return doubts_; } // still to be asked
  /// As the program expects it. Cost: as errorRatings().
  [[nodiscard]] ExpectedAgreement expected(const Progress& progress = {}) const;

private:
  void find(const Progress& progress);
  [[nodiscard]] std::size_t chosen() const; // of doubts_, which is asked about next

  std::shared_ptr<const PointCloud> cloud_;
  Skeleton plant_;
  Skeleton reference_;
  PlantScale scale_;
  Eigen::Vector3d up_;
  Options options_;
  Oracle oracle_;
  SpatialIndex index_;
  PointDistances distances_;
  LearnedOdds learned_;
  std::vector<Doubt> found_;  // with odds as they were fitted
  std::vector<Doubt> doubts_; // as learned
  std::vector<Doubt> answered_;
  std::size_t changes_ = 0;
};

} // namespace espalier
