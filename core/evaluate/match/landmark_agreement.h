#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <vector>

namespace espalier {

/// How many marked places of a result and of a reference belong to each other.
struct LandmarkAgreement {
  double distance = 0;       // [L], the farthest that two of a pair may be apart
  std::size_t matched = 0;   // pairs
  std::size_t result = 0;    // places
  std::size_t reference = 0; // places

  [[nodiscard]] double precision() const; // in [0, 1]: share of the result's places; 1 if none
  [[nodiscard]] double recall() const;    // in [0, 1]: share of the reference's; 1 if none
  [[nodiscard]] double f() const;
};

/// Pairs places one to one and at most `distance` apart.
///
/// The sum of distances in pairs, plus half of `distance` per place left alone, is least: two
/// places within `distance` never both stay alone.
/// @param distance [L], >= 0
/// @return by place of the result: its partner among those of the reference; none if left alone
/// Deterministic. Time and memory grow with the pairs within `distance`.
[[nodiscard]] std::vector<std::optional<std::size_t>>
landmarkPairs(const std::vector<Eigen::Vector3d>& result,
              const std::vector<Eigen::Vector3d>& reference, double distance);

/// How many tips, or branchings, landmarkPairs() pairs.
[[nodiscard]] LandmarkAgreement landmarkAgreement(const std::vector<Eigen::Vector3d>& result,
                                                  const std::vector<Eigen::Vector3d>& reference,
                                                  double distance);

} // namespace espalier
