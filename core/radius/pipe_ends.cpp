#include "core/radius/pipe_ends.h"

#include "core/base/parallel.h"
#include "core/base/quantile.h"
#include "core/radius/section_circle.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <variant>

namespace espalier {
namespace {

/// A node of the lowest wood, and the number of nodes it carries, itself included.
struct Place {
  NodeId id;
  double carried;
};

/// From the heaviest root over the child that carries most, to a tip.
std::vector<Place> heaviestChain(const Skeleton& skeleton, const std::vector<double>& carried) {
  const auto heavier = [&](NodeId a, NodeId b) {
    return carried[indexOf(a)] < carried[indexOf(b)];
  };
  std::vector<Place> chain;
  std::vector<NodeId> next = skeleton.roots();
  while (!next.empty()) {
    const NodeId id = *std::ranges::max_element(next, heavier);
    chain.push_back({id, carried[indexOf(id)]});
    next = skeleton.children(id);
  }
  return chain;
}

/// How many nodes of `chain` carry at least `share` of its first, and 2: a tip is no foot.
std::size_t countOfFoot(const std::vector<Place>& chain, double share) {
  const auto isFoot = [&](const Place& place) {
    return place.carried >= std::max(2.0, share * chain.front().carried);
  };
  return static_cast<std::size_t>(std::ranges::find_if_not(chain, isFoot) - chain.begin());
}

/// A skeleton of a chain alone, whose ids are the places in it.
Skeleton alone(const Skeleton& skeleton, const std::vector<Place>& chain) {
  Skeleton result;
  std::optional<NodeId> below;
  for (const Place& place : chain)
    below = result.add({.position = skeleton[place.id].position, .parent = below});
  return result;
}

/// The radius of the outermost wood [L].
std::optional<double> tipRadius(const Skeleton& skeleton, const std::vector<double>& carried,
                                const std::vector<MeasuredRadius>& wood) {
  constexpr double mostCarried = 3;
  constexpr double share = 0.01;
  std::vector<double> radii;
  for (const NodeId id : skeleton.ids())
    if (carried[indexOf(id)] <= mostCarried && wood[indexOf(id)].radius > 0)
      radii.push_back(wood[indexOf(id)].radius);
  return quantile(std::move(radii), share);
}

/// A radius of the lowest wood.
struct FootRadius {
  double carried; // nodes, >= 2
  double radius;  // [L], > 0
};

std::vector<FootRadius> footRadii(const std::vector<Place>& chain,
                                  const std::vector<double>& lowest,
                                  const std::vector<MeasuredRadius>& wood) {
  std::vector<FootRadius> foot;
  for (const Place& place : chain)
    if (lowest[indexOf(place.id)] > 0 && place.carried >= 2)
      foot.push_back({place.carried, lowest[indexOf(place.id)]});
  if (!foot.empty() || chain.empty()) return foot;
  for (std::size_t i = 0; i < countOfFoot(chain, 0.5); ++i)
    if (wood[indexOf(chain[i].id)].radius > 0)
      foot.push_back({chain[i].carried, wood[indexOf(chain[i].id)].radius});
  return foot;
}

/// The median of the tip radii that `exponent` leads to from the foot. pre: foot is not empty
double tipOf(const std::vector<FootRadius>& foot, double exponent) {
  std::vector<double> tips;
  tips.reserve(foot.size());
  for (const FootRadius& each : foot)
    tips.push_back(each.radius / std::pow(each.carried, exponent));
  return *quantile(std::move(tips), 0.5);
}

/// The median of the exponents from the tip to the foot. pre: foot is not empty
double exponentOf(const std::vector<FootRadius>& foot, double tip) {
  std::vector<double> exponents;
  exponents.reserve(foot.size());
  for (const FootRadius& each : foot)
    exponents.push_back(std::log(each.radius / tip) / std::log(each.carried));
  return *quantile(std::move(exponents), 0.5);
}

NodeCountPipeOptions endsBy(double tip, double exponent, double heaviest) {
  return {.rootRadius = tip * std::pow(heaviest, exponent), .apexRadius = tip};
}

} // namespace

std::vector<double> lowestWoodRadii(const Skeleton& skeleton, const IndexedPoints& points,
                                    const Progress& progress) {
  constexpr std::size_t fewest = 5;
  std::vector<double> radii(skeleton.idEnd(), 0);
  if (skeleton.isEmpty()) return radii;
  const std::vector<Place> chain = heaviestChain(skeleton, carriedNodes(skeleton));
  const Skeleton stem = alone(skeleton, chain);
  const CrossSections sections(stem, points);
  const std::size_t all = countOfFoot(chain, 0);
  std::size_t found = 0;
  std::size_t first = 0;
  for (double share = 0.5; first < all && found < fewest; share /= 2) {
    const std::size_t last = countOfFoot(chain, share);
    std::vector<NodeId> nodes;
    for (; first < last; ++first)
      nodes.push_back(NodeId{static_cast<std::uint32_t>(first)});
    for (const auto& [id, radius] :
         sectionRadii(sections, nodes, RadiusMeasure::circle, progress.part(0, 0)).radii) {
      radii[indexOf(chain[indexOf(id)].id)] = radius;
      ++found;
    }
  }
  progress.update(1);
  return radii;
}

PipeEnds pipeEnds(const Skeleton& skeleton, const std::vector<double>& lowest,
                  const std::vector<MeasuredRadius>& wood, double otherwise) {
  constexpr double leastExponent = 1.0 / 5;
  constexpr double mostExponent = 1;
  constexpr double published = 1 / publishedPipe;
  const std::vector<double> carried = carriedNodes(skeleton);
  const std::vector<Place> chain = heaviestChain(skeleton, carried);
  const double heaviest = chain.empty() ? 1 : chain.front().carried;
  const std::vector<FootRadius> foot = footRadii(chain, lowest, wood);
  const std::optional<double> tip = tipRadius(skeleton, carried, wood);
  if (foot.empty())
    return {.radii = endsBy(tip.value_or(otherwise), published, heaviest),
            .basis = tip ? PipeBasis::tipsOnly : PipeBasis::nothing};
  PipeEnds ends{.radii = endsBy(tipOf(foot, published), published, heaviest),
                .basis = PipeBasis::footOnly};
  if (!tip) return ends;
  const double exponent = exponentOf(foot, *tip);
  ends.footToTip = std::pow(heaviest, exponent);
  if (exponent < leastExponent || exponent > mostExponent) return ends;
  return {.radii = endsBy(*tip, exponent, heaviest),
          .basis = PipeBasis::foot,
          .footToTip = ends.footToTip};
}

} // namespace espalier
