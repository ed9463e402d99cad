#include "core/pipeline/method_parts.h"

#include "core/base/shown_message.h"
#include "core/cloud/repeated_points.h"
#include "core/graph/densities.h"

#include <algorithm>
#include <utility>

namespace espalier {

Method noMethod(std::string help) {
  return {.name = "none",
          .label = Shown::tr("None"),
          .help = std::move(help),
          .source = {},
          .options = {},
          .seesRoot = false,
          .run = [](PipelineState&, const Values&, const Progress&) {}};
}

bool isNoMethod(const Method& method) {
  return method.name == noMethod({}).name;
}

Option linksOption(const char* help) {
  return countOption("neighbors", Shown::tr("Neighbors"), 3, 64, help);
}

Option linksOverGapsOption() {
  return linksOption(
      Shown::tr("Links per point along which distances are measured; more bridge wider gaps."));
}

Option linkKindOption() {
  Option option = optionOf<OptionKind::choice>(
      "links", Shown::tr("Links"), 0, 0,
      Shown::tr("Which neighbors points are linked to. All around and Voronoi link the lines in "
                "which a scanner samples a surface, where the nearest points are all of one line; "
                "they choose of three times as many."));
  option.choices = {{"nearest", Shown::tr("Nearest")},
                    {"angles", Shown::tr("All around")},
                    {"voronoi", Shown::tr("Voronoi")}};
  return option;
}

Option densityMeasureOption() {
  Option option = optionOf<OptionKind::choice>(
      "densities", Shown::tr("Densities"), 0, 0,
      Shown::tr(
          "By range, a density counts by its place between the thinnest and the densest; by "
          "rank, by the share of the points that lie thinner, so that few dense places do not "
          "make all others thin."));
  option.choices = {{"range", Shown::tr("By range")}, {"rank", Shown::tr("By rank")}};
  return option;
}

Option widestGapOption() {
  return lengthOption(
      "widest_gap", Shown::tr("Widest gap"), 0, 10000,
      Shown::tr("Parts of the plant farther apart than this are not joined; 0 joins all."));
}

Option thickWoodOption() {
  return lengthOption(
      "thick_wood", Shown::tr("Thick wood"), 0, 10000,
      Shown::tr("Points of wood thicker than this are drawn to its axis first, or they would leave "
                "strands on it; 0 draws none."));
}

Option coverageOption() {
  return ratioOption(
      "least_coverage", Shown::tr("Least coverage"), 0.1, 1,
      Shown::tr("Share of the circumference that points must cover before a fit is trusted."));
}

Option cylinderLengthOption() {
  return ratioOption("length", Shown::tr("Length"), 1, 30,
                     Shown::tr("How much of the wood a cylinder is fitted to, in radii."));
}

std::vector<Eigen::Index> keptPoints(const PipelineState& state) {
  std::vector<Eigen::Index> kept;
  for (Eigen::Index i = 0; i < state.cloud->size(); ++i)
    if (!state.isLeftOut[static_cast<std::size_t>(i)]) kept.push_back(i);
  return kept;
}

std::vector<Eigen::Index> keptPlaces(const PipelineState& state) {
  std::vector<Eigen::Index> places = keptPoints(state);
  const auto isRepeated = [&](Eigen::Index a, Eigen::Index b) {
    return state.cloud->positions().col(a) == state.cloud->positions().col(b);
  };
  places.erase(std::unique(places.begin(), places.end(), isRepeated), places.end());
  return places;
}

Eigen::Matrix3Xf keptPositions(const PipelineState& state) {
  return state.cloud->positions()(Eigen::all, keptPoints(state));
}

void followKept(Eigen::Matrix3Xf& places, const PipelineState& state) {
  const auto isKept = [&](Eigen::Index point) {
    return !state.isLeftOut[static_cast<std::size_t>(point)];
  };
  forEachRepeated(*state.cloud, isKept, [&](Eigen::Index point, Eigen::Index before) {
    places.col(point) = places.col(before);
  });
}

void requirePlant(const std::vector<Eigen::Index>& kept) {
  if (kept.size() < 2)
    throw ShownError({Shown::tr("fewer than 2 points are left after cleaning: clean less, choose "
                                "method none, or bring points back")});
}

void reconstructKept(
    PipelineState& state,
    const std::function<Skeleton(const Eigen::Matrix3Xf& points, Eigen::Index root)>& reconstruct) {
  const std::vector<Eigen::Index> kept = keptPlaces(state);
  requirePlant(kept);
  const auto behindRoot = std::ranges::upper_bound(kept, state.root); // right behind its place
  const Eigen::Matrix3Xf points = (*state.contracted)(Eigen::all, kept);
  Skeleton local = reconstruct(points, behindRoot - kept.begin() - 1);
  for (const NodeId id : local.ids())
    local.setPosition(id, local[id].position + state.cloud->origin());
  state.setSkeleton(std::move(local));
}

std::vector<float> scannedDensities(const SpatialIndex& scanned, DensityMeasure measure,
                                    const Progress& progress) {
  constexpr int nearest = 16; // as PlantScan3D has it
  return normalizedDensities(nearestDensities(scanned, nearest, progress), measure);
}

std::shared_ptr<const SpatialIndex> scannedIndex(const PipelineState& state,
                                                 const std::vector<Eigen::Index>& points,
                                                 const Progress& progress) {
  const Eigen::Matrix3Xf& scan = state.cloud->positions();
  if (state.index && static_cast<Eigen::Index>(points.size()) == scan.cols()) return state.index;
  struct Indexed {
    Eigen::Matrix3Xf points;
    SpatialIndex index;
    Indexed(Eigen::Matrix3Xf some, const Progress& progress)
        : points(std::move(some)), index(points, progress) {}
  };
  const auto indexed = std::make_shared<const Indexed>(scan(Eigen::all, points), progress);
  return {indexed, &indexed->index};
}

} // namespace espalier
