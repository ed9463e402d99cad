#include "core/clean/plants.h"

#include "core/base/parallel.h"
#include "core/base/quantile.h"
#include "core/cloud/voxels.h"
#include "core/graph/components.h"
#include "core/graph/disjoint_sets.h"
#include "core/graph/geodesic.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>

namespace espalier {
namespace {

/// A stem, and the places that paths start from.
struct Stem {
  Eigen::Vector3d base = Eigen::Vector3d::Zero(); // [L]
  std::vector<Eigen::Index> places;
  double section = 0; // places in a layer one cube high; 0: not known
};

/// What of the slab is in one part.
struct SlabPart {
  Stem stem;
  float lowest = std::numeric_limits<float>::max();
  float highest = std::numeric_limits<float>::lowest();
};

std::vector<SlabPart> partsOfSlab(const Eigen::Matrix3Xf& places,
                                  const std::vector<Eigen::Index>& slab,
                                  const std::vector<float>& heights, double longest,
                                  const Progress& progress) {
  const Eigen::Matrix3Xf low = places(Eigen::all, slab);
  const NeighborhoodGraph graph(low, 6, progress);
  std::vector<bool> isMet(slab.size(), false);
  std::vector<SlabPart> parts;
  for (Eigen::Index first = 0; first < low.cols(); ++first) {
    if (isMet[static_cast<std::size_t>(first)]) continue;
    SlabPart part;
    for (const Eigen::Index at : pointsLinkedTo(graph, first, static_cast<float>(longest), isMet)) {
      const Eigen::Index place = slab[static_cast<std::size_t>(at)];
      part.stem.places.push_back(place);
      part.stem.base += places.col(place).cast<double>();
      part.lowest = std::min(part.lowest, heights[static_cast<std::size_t>(place)]);
      part.highest = std::max(part.highest, heights[static_cast<std::size_t>(place)]);
    }
    part.stem.base /= static_cast<double>(part.stem.places.size());
    parts.push_back(std::move(part));
  }
  return parts;
}

/// Stems so near that they are of one plant, joined.
std::vector<Stem> joinedStems(std::vector<Stem> stems, double together) {
  for (std::size_t i = 0; i < stems.size(); ++i)
    for (std::size_t j = i + 1; j < stems.size();) {
      const double apart = (stems[i].base - stems[j].base).head<2>().norm();
      if (apart > together) {
        ++j;
        continue;
      }
      const auto a = static_cast<double>(stems[i].places.size());
      const auto b = static_cast<double>(stems[j].places.size());
      stems[i].base = (a * stems[i].base + b * stems[j].base) / (a + b);
      stems[i].section += stems[j].section;
      stems[i].places.insert(stems[i].places.end(), stems[j].places.begin(), stems[j].places.end());
      stems.erase(stems.begin() + static_cast<std::ptrdiff_t>(j));
      j = i + 1; // its base has moved
    }
  return stems;
}

/// Those that reach from the lower to the upper side of the slab.
std::vector<Stem> stemsIn(const Eigen::Matrix3Xf& places, const std::vector<float>& heights,
                          const PlantsOptions& options, double edge, const Progress& progress) {
  constexpr double margin = 0.3; // of the slab
  const double from = options.slabFrom;
  const double to = std::max<double>(options.slabTo, from + 5 * edge);
  std::vector<Eigen::Index> slab;
  for (std::size_t i = 0; i < heights.size(); ++i)
    if (static_cast<double>(heights[i]) >= from && static_cast<double>(heights[i]) <= to)
      slab.push_back(static_cast<Eigen::Index>(i));
  if (slab.empty()) return {};
  std::vector<Stem> stems;
  std::size_t most = 0;
  for (SlabPart& part : partsOfSlab(places, slab, heights, 3 * edge, progress))
    if (static_cast<double>(part.lowest) <= from + margin * (to - from) &&
        static_cast<double>(part.highest) >= to - margin * (to - from)) {
      most = std::max(most, part.stem.places.size());
      part.stem.section =
          static_cast<double>(part.stem.places.size()) * edge /
          std::max(edge, static_cast<double>(part.highest) - static_cast<double>(part.lowest));
      stems.push_back(std::move(part.stem));
    }
  std::erase_if(stems, [&](const Stem& stem) {
    return static_cast<double>(stem.places.size()) < options.leastStem * static_cast<double>(most);
  });
  return joinedStems(std::move(stems), options.together);
}

std::vector<Stem> stemsAt(const std::vector<Eigen::Vector3d>& bases,
                          const Eigen::Matrix3Xf& places) {
  std::vector<Stem> stems;
  for (const Eigen::Vector3d& base : bases)
    stems.push_back({base, {nearestPoint(places, base.cast<float>())}});
  return stems;
}

/// Stems that are not those of other plants: where wood leads from one to another that is nowhere
/// thinner than it is itself, the thinner one is a branch that reaches the ground.
/// @param isOwn  by stem; false for branches
std::vector<bool> ownStems(const NeighborhoodGraph& graph, const std::vector<Stem>& stems,
                           const std::vector<float>& thickness, const PlantsOptions& options) {
  constexpr double mostly = 0.75; // of the places of a stem; ground may be left at its foot
  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  DisjointSets wood(static_cast<std::size_t>(graph.size()));
  std::vector<std::uint32_t> stemIn(static_cast<std::size_t>(graph.size()), none); // by set
  std::vector<double> thick;
  for (std::uint32_t stem = 0; stem < stems.size(); ++stem) {
    std::vector<double> all;
    for (const Eigen::Index place : stems[stem].places) {
      all.push_back(static_cast<double>(thickness[static_cast<std::size_t>(place)]));
      wood.join(static_cast<std::uint32_t>(place),
                static_cast<std::uint32_t>(stems[stem].places.front()));
    }
    stemIn[wood.find(static_cast<std::uint32_t>(stems[stem].places.front()))] = stem;
    thick.push_back(*quantile(std::move(all), mostly));
  }
  struct ThickLink {
    float thickness;
    std::uint32_t from, to;
  };
  std::vector<ThickLink> links;
  for (std::uint32_t place = 0; place < stemIn.size(); ++place)
    for (const NeighborhoodGraph::Link& link : graph.links(place))
      if (place < link.to && static_cast<double>(link.length) <= options.widestGap)
        links.push_back({std::min(thickness[place], thickness[link.to]), place, link.to});
  parallelSort(links.begin(), links.end(), [](const ThickLink& a, const ThickLink& b) {
    return std::tie(b.thickness, a.from, a.to) < std::tie(a.thickness, b.from, b.to);
  });
  std::vector<bool> isOwn(stems.size(), true);
  for (const ThickLink& link : links) {
    const std::uint32_t a = stemIn[wood.find(link.from)];
    const std::uint32_t b = stemIn[wood.find(link.to)];
    if (!wood.join(link.from, link.to)) continue;
    std::uint32_t& both = stemIn[wood.find(link.from)];
    both = a == none ? b : a;
    if (a == none || b == none) continue;
    const bool isFirst = stems[a].section >= stems[b].section;
    both = isFirst ? a : b;
    if (static_cast<double>(link.thickness) >= options.oneWood * std::min(thick[a], thick[b]))
      isOwn[isFirst ? b : a] = false;
  }
  return isOwn;
}

/// The plant of each place, by the number of its stem, from 1; 0: no path leads there, or over too
/// wide a gap.
/// @param areSure  stems are as the user says
std::vector<std::uint32_t> nearestStems(const Voxels& voxels, const Eigen::Matrix3Xf& points,
                                        const Eigen::Matrix3Xf& places,
                                        const std::vector<Stem>& stems, bool areSure,
                                        const PlantsOptions& options, const Progress& progress) {
  constexpr double thinnest = 0.2; // cubes
  const NeighborhoodGraph graph =
      joined(NeighborhoodGraph(places, options.neighbors, progress.part(0, 0.3)), places,
             static_cast<float>(options.widestGap), progress.part(0.3, 0.4));
  const std::vector<float> thickness =
      woodThickness(voxels, points, places, graph, progress.part(0.4, 0.55));
  const std::vector<bool> isOwn =
      areSure ? std::vector<bool>(stems.size(), true)
              : ownStems(graph, stems,
                         fullThickness(thickness, places, voxels.edge(), progress.part(0.55, 0.6)),
                         options);
  constexpr std::uint32_t open = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> stemOf(static_cast<std::size_t>(places.cols()), open);
  std::vector<Eigen::Index> sources;
  for (std::size_t stem = 0; stem < stems.size(); ++stem)
    for (const Eigen::Index place : stems[stem].places) {
      if (!isOwn[stem]) break;
      sources.push_back(place);
      stemOf[static_cast<std::size_t>(place)] = static_cast<std::uint32_t>(stem + 1);
    }
  const std::vector<std::uint32_t> back =
      woodPaths(graph, places, thickness, thinnest * voxels.edge(), sources, options.costs,
                progress.part(0.6, 1));
  std::vector<std::uint32_t> chain;
  for (std::uint32_t first = 0; first < stemOf.size(); ++first) {
    std::uint32_t at = first;
    while (stemOf[at] == open) {
      chain.push_back(at);
      const std::uint32_t next = back[at];
      const bool isCut =
          next == Geodesics::none ||
          static_cast<double>((places.col(at) - places.col(next)).norm()) > options.widestGap;
      if (isCut)
        stemOf[at] = 0;
      else
        at = next;
    }
    for (; !chain.empty(); chain.pop_back())
      stemOf[chain.back()] = stemOf[at];
  }
  return stemOf;
}

/// Numbers plants by their sizes, and drops the small ones.
PlantParts sorted(std::vector<std::uint32_t> ofPoint, const std::vector<Stem>& stems,
                  double leastShare) {
  std::vector<Eigen::Index> sizes(stems.size() + 1, 0);
  for (const std::uint32_t stem : ofPoint)
    ++sizes[stem];
  std::vector<std::uint32_t> order(stems.size());
  std::iota(order.begin(), order.end(), 1U);
  std::ranges::stable_sort(order, [&](auto a, auto b) { return sizes[a] > sizes[b]; });
  PlantParts result;
  std::vector<std::uint32_t> number(stems.size() + 1, 0);
  for (const std::uint32_t stem : order) {
    if (sizes[stem] == 0 ||
        static_cast<double>(sizes[stem]) < leastShare * static_cast<double>(sizes[order.front()]))
      continue;
    result.bases.push_back(stems[stem - 1].base);
    result.sizes.push_back(sizes[stem]);
    number[stem] = static_cast<std::uint32_t>(result.sizes.size());
  }
  for (std::uint32_t& stem : ofPoint)
    stem = number[stem];
  result.ofPoint = std::move(ofPoint);
  return result;
}

} // namespace

PlantsOptions resolved(PlantsOptions options, const PlantScale& scale) {
  for (Length PlantsOptions::*length :
       {&PlantsOptions::slabFrom, &PlantsOptions::slabTo, &PlantsOptions::together,
        &PlantsOptions::widestGap, &PlantsOptions::voxel})
    options.*length = lengthAt(options.*length, scale);
  options.ground = resolved(options.ground, scale);
  return options;
}

PlantParts plantsAmong(const Eigen::Matrix3Xf& points, const std::vector<float>& heights,
                       const std::vector<Eigen::Vector3d>& bases, const PlantsOptions& options,
                       const Progress& progress) {
  std::vector<Eigen::Index> above;
  for (std::size_t i = 0; i < heights.size(); ++i)
    if (heights[i] >= 0) above.push_back(static_cast<Eigen::Index>(i));
  if (above.empty()) return {.ofPoint = std::vector<std::uint32_t>(heights.size(), 0)};
  const Eigen::Matrix3Xf standing = points(Eigen::all, above);
  const Voxels voxels(standing, options.voxel, progress.part(0, 0.2));
  const Eigen::Matrix3Xf places = voxels.means(standing);
  std::vector<float> placeHeights(voxels.count());
  for (std::size_t cube = 0; cube < voxels.count(); ++cube) {
    double sum = 0;
    for (const std::uint32_t member : voxels.members(cube))
      sum += static_cast<double>(heights[static_cast<std::size_t>(above[member])]);
    placeHeights[cube] = static_cast<float>(sum / static_cast<double>(voxels.members(cube).size()));
  }
  const std::vector<Stem> stems =
      bases.empty() ? stemsIn(places, placeHeights, options, voxels.edge(), progress.part(0.2, 0.3))
                    : stemsAt(bases, places);
  if (stems.empty()) return {.ofPoint = std::vector<std::uint32_t>(heights.size(), 0)};
  const std::vector<std::uint32_t> stemOf =
      nearestStems(voxels, standing, places, stems, !bases.empty(), options, progress.part(0.3, 1));
  std::vector<std::uint32_t> ofPoint(heights.size(), 0);
  for (std::size_t cube = 0; cube < voxels.count(); ++cube)
    for (const std::uint32_t member : voxels.members(cube))
      ofPoint[static_cast<std::size_t>(above[member])] = stemOf[cube];
  return sorted(std::move(ofPoint), stems, options.leastShare);
}

PlantParts plantsAbove(const GroundSurface& ground, const Eigen::Matrix3Xf& points,
                       const std::vector<Eigen::Vector3d>& bases, const PlantsOptions& options,
                       const Progress& progress) {
  std::vector<float> heights = heightsAbove(ground, points);
  for (float& height : heights)
    if (static_cast<double>(height) <= options.ground.width()) height = -1;
  return plantsAmong(points, heights, bases, options, progress);
}

PlantParts plantsOf(const PointCloud& cloud, const PointSet& leftOut, UpAxis up,
                    const PlantScale& scale, const std::vector<Eigen::Vector3d>& bases,
                    const PlantsOptions& options, const Progress& progress) {
  const PlantsOptions exact = resolved(options, scale);
  const StandingPoints all = standingPoints(cloud, PointSet{}, up);
  const StandingPoints kept = standingPoints(cloud, leftOut, up);
  const GroundSurface ground = groundBelow(all.positions, exact.ground, progress.part(0, 0.3));
  std::vector<Eigen::Vector3d> turned;
  for (const Eigen::Vector3d& base : bases)
    turned.push_back(kept.fromFile(base));
  PlantParts found = plantsAbove(ground, kept.positions, turned, exact, progress.part(0.3, 1));
  PlantParts result;
  result.ofPoint.assign(static_cast<std::size_t>(cloud.size()), 0);
  for (std::size_t i = 0; i < kept.columns.size(); ++i)
    result.ofPoint[static_cast<std::size_t>(kept.columns[i])] = found.ofPoint[i];
  for (const Eigen::Vector3d& base : found.bases)
    result.bases.push_back(kept.toFile(base));
  result.sizes = std::move(found.sizes);
  return result;
}

} // namespace espalier
