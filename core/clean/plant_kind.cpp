#include "core/clean/plant_kind.h"

#include "core/graph/components.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

constexpr float widestLink = 3; // in spacings, within a part
constexpr std::size_t fewestOfPart = 20;

/// Groups of points that lie near each other, by their columns, but for small ones.
std::vector<std::vector<Eigen::Index>> partsAmong(const Eigen::Matrix3Xf& points, double spacing,
                                                  std::size_t fewest, const Progress& progress) {
  std::vector<std::vector<Eigen::Index>> parts;
  if (points.cols() < 2) return parts;
  const NeighborhoodGraph graph(points, 7, progress);
  std::vector<bool> isMet(static_cast<std::size_t>(points.cols()));
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    if (isMet[static_cast<std::size_t>(i)]) continue;
    auto part = pointsLinkedTo(graph, i, widestLink * static_cast<float>(spacing), isMet);
    if (part.size() >= fewest) parts.push_back(std::move(part));
  }
  return parts;
}

template <class Accepts>
Eigen::Matrix3Xf pointsOf(const Eigen::Matrix3Xf& points, const Accepts& accepts) {
  std::vector<Eigen::Index> some;
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    if (accepts(i)) some.push_back(i);
  return points(Eigen::all, some);
}

/// The logarithm of how many parts the plant has in a slice about a share of its height.
double partsInSlice(const Eigen::Matrix3Xf& points, double spacing, float share,
                    const Progress& progress) {
  const float low = points.row(2).minCoeff();
  const float height = points.row(2).maxCoeff() - low;
  const float half = std::max(0.02F * height, static_cast<float>(spacing));
  const Eigen::Matrix3Xf slice = pointsOf(
      points, [&](Eigen::Index i) { return std::abs(points(2, i) - low - share * height) < half; });
  constexpr std::size_t fewest = 3;
  return std::log(1 + static_cast<double>(partsAmong(slice, spacing, fewest, progress).size()));
}

/// Parts of blades and needles, each weighing as much as it has points.
struct FoliageParts {
  double size = 0;       // the logarithm of their longest deviation, by the height of the plant
  double narrowness = 0; // the second deviation by the first
  std::size_t count = 0;
};

FoliageParts foliageParts(const Eigen::Matrix3Xf& points, double spacing, double height,
                          const Progress& progress) {
  FoliageParts result;
  double weights = 0;
  for (const std::vector<Eigen::Index>& part :
       partsAmong(points, spacing, fewestOfPart, progress)) {
    const Eigen::Matrix3Xd places = points(Eigen::all, part).cast<double>();
    const Eigen::Matrix3Xd about = places.colwise() - places.rowwise().mean();
    const Eigen::Matrix3d moments = about * about.transpose() / static_cast<double>(part.size());
    const Eigen::Vector3d squares =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(moments, Eigen::EigenvaluesOnly)
            .eigenvalues()
            .cwiseMax(0);
    const auto weight = static_cast<double>(part.size());
    const double longest = std::sqrt(squares[2]);
    result.size += weight * std::log(longest / height + 1e-4);
    if (longest > 0) result.narrowness += weight * std::sqrt(squares[1]) / longest;
    weights += weight;
    ++result.count;
  }
  if (weights > 0) {
    result.size /= weights;
    result.narrowness /= weights;
  } else {
    result.size = std::log(1e-4); // smaller than any
  }
  return result;
}

/// How often shapes lead astray that leave no doubt: of simulated plants that were not fitted on,
/// 10 of 161.
constexpr double misled = 0.06;

/// How likely a plant of this height is of a kind, against one of no height: few herbs and grasses
/// are taller than reed or sunflowers, and trees begin as seedlings.
double likelinessAt(PlantKind kind, double meters) {
  if (kind != PlantKind::herb && kind != PlantKind::grass) return 1;
  constexpr double half = 4;
  return 1 / (1 + std::pow(meters / half, 4));
}

} // namespace

KindFeatures kindFeatures(const Eigen::Matrix3Xf& points, const std::vector<Organ>& organs,
                          double spacing, const Progress& progress) {
  KindFeatures features = {};
  for (std::size_t i = 0; i < allOrgans.size(); ++i)
    features[i] = static_cast<double>(std::ranges::count(organs, allOrgans[i])) /
                  static_cast<double>(organs.size());
  const Eigen::Vector3d sizes =
      (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).cast<double>();
  const double height = sizes.z() + spacing;
  features[4] = std::log(height / (sizes.head<2>().maxCoeff() + spacing));
  features[5] = partsInSlice(points, spacing, 0.1F, progress);
  features[6] = partsInSlice(points, spacing, 0.5F, progress);
  features[7] = partsInSlice(points, spacing, 0.75F, progress);
  const Eigen::Matrix3Xf foliage = pointsOf(points, [&](Eigen::Index i) {
    const Organ organ = organs[static_cast<std::size_t>(i)];
    return organ == Organ::blade || organ == Organ::needle;
  });
  const FoliageParts parts = foliageParts(foliage, spacing, height, progress);
  features[8] = parts.size;
  features[9] = parts.narrowness;
  features[10] = std::log(1 + static_cast<double>(parts.count));
  features[11] = std::log(height / spacing);
  return features;
}

LikelyKind likelyKind(const KindFeatures& features, const KindOdds& odds,
                      std::optional<double> height) {
  std::array<double, allPlantKinds.size()> probabilities;
  double sum = 0;
  for (std::size_t i = 0; i < probabilities.size(); ++i)
    sum += probabilities[i] = 1 / (1 + std::exp(-odds[i].value(features)));
  double possible = 0;
  for (std::size_t i = 0; i < probabilities.size(); ++i) {
    const double byShape =
        (1 - misled) * probabilities[i] / sum + misled / static_cast<double>(probabilities.size());
    possible += probabilities[i] = byShape * (height ? likelinessAt(allPlantKinds[i], *height) : 1);
  }
  const auto best =
      static_cast<std::size_t>(std::ranges::max_element(probabilities) - probabilities.begin());
  return {allPlantKinds[best], probabilities[best] / possible};
}

} // namespace espalier
