#include "core/clean/ground.h"
#include "core/clean/plants.h"
#include "core/clean/pole.h"
#include "core/clean/wire.h"
#include "core/pipeline/clean_parts.h"
#include "core/pipeline/methods.h"
#include "core/pipeline/plants_of_state.h"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

namespace espalier {
namespace {

Option noiseOption() {
  return lengthOption("noise", Shown::tr("Noise"), 0, 1000,
                      Shown::tr("Points this near are of it, too, where the scan scatters wide."));
}

template <class Options, class... Path>
void addClothOptions(OptionTable<Options>& table, Path... path) {
  table.add(lengthOption("cell", Shown::tr("Cell"), 1, 100000,
                         Shown::tr("Between the particles of the cloth; smaller ones follow "
                                   "rougher ground.")),
            path..., &GroundOptions::cell);
  table.add(lengthOption("tolerance", Shown::tr("Tolerance"), 0, 100000,
                         Shown::tr("Points up to this above the cloth are of the ground.")),
            path..., &GroundOptions::tolerance);
  table.add(noiseOption(), path..., &GroundOptions::noise);
  table.add(countOption("rigidness", Shown::tr("Rigidness"), 1, 10,
                        Shown::tr("1 follows steep ground, 3 spans wide gaps below crowns.")),
            path..., &GroundOptions::rigidness);
}

/// Whether the ground was set aside before: under most of what the cloth touches are points that
/// were. `isGround` has an entry per standing point.
bool isGroundAside(const PipelineState& state, const StandingPoints& standing,
                   const GroundSurface& ground, const std::vector<bool>& isGround) {
  constexpr double most = 0.5; // of the cells that hold ground
  const StandingPoints all = allStandingOf(state);
  if (all.columns.size() == standing.columns.size()) return false; // nothing was
  const std::vector<float> heights = heightsAbove(ground, all.positions);
  const auto cellOf = [&](const Eigen::Vector3f& place) {
    const Eigen::Array2d cell =
        ((place.head<2>().cast<double>() - ground.corner) / ground.cell).array().floor();
    return std::pair{cell.x(), cell.y()};
  };
  std::set<std::pair<double, double>> below;
  for (std::size_t i = 0; i < heights.size(); ++i)
    if (heights[i] < 0 && state.isLeftOut[static_cast<std::size_t>(all.columns[i])])
      below.insert(cellOf(all.positions.col(static_cast<Eigen::Index>(i))));
  std::set<std::pair<double, double>> touched;
  for (std::size_t i = 0; i < isGround.size(); ++i)
    if (isGround[i]) touched.insert(cellOf(standing.positions.col(static_cast<Eigen::Index>(i))));
  const auto covered = std::ranges::count_if(
      touched, [&](const std::pair<double, double>& cell) { return below.contains(cell); });
  return static_cast<double>(covered) > most * static_cast<double>(touched.size());
}

Method groundMethod() {
  using Options = GroundOptions;
  OptionTable<Options> table;
  addClothOptions(table);
  table.add(countOption("iterations", Shown::tr("Iterations"), 1, 10000,
                        Shown::tr("Steps that the cloth falls at most.")),
            &Options::iterations);
  table.add(flagOption("follow_slopes", Shown::tr("Follow slopes"),
                       Shown::tr("Pulls the cloth onto ground near it where it is steep.")),
            &Options::followSlopes);
  return {.name = "cloth",
          .label = Shown::tr("Cloth"),
          .help = Shown::tr("Lays a cloth on the scan from below and leaves out what it touches."),
          .source = "W. Zhang et al., Remote Sensing 8(6), 2016",
          .options = table.descriptions(),
          .seesRoot = false,
          .seesUp = true,
          .changesScale = true,
          .run = [table](PipelineState& state, const Values& values, const Progress& progress) {
            leaveOutFarPoints(state);
            const StandingPoints standing = standingOf(state);
            const Options options = table.with(values);
            const GroundSurface ground = groundBelow(standing.positions, options, progress);
            const std::vector<float> heights = heightsAbove(ground, standing.positions);
            std::vector<bool> isGround(heights.size());
            for (std::size_t i = 0; i < heights.size(); ++i)
              isGround[i] = static_cast<double>(heights[i]) <= options.width();
            if (isGroundAside(state, standing, ground, isGround))
              state.notes.push_back({Shown::tr("the ground was set aside before")});
            else
              leaveOut(state, standing.columns, isGround);
          }};
}

struct NotesOnLeftOut {
  const char* none;
  const char* one;
  const char* many; // %1 of them
};

/// Leaves out the points of all that were found, and says how many there are. What is nearly all of
/// a scan is the plant itself.
template <class Found>
void leaveOutAll(PipelineState& state, const StandingPoints& standing,
                 const std::vector<Found>& found, const NotesOnLeftOut& notes) {
  constexpr double most = 0.9; // of the points
  std::size_t points = 0;
  for (const Found& each : found)
    points += each.points.size();
  if (found.empty() ||
      static_cast<double>(points) > most * static_cast<double>(standing.columns.size())) {
    state.notes.push_back({notes.none});
    return;
  }
  for (const Found& each : found)
    for (const Eigen::Index point : each.points)
      state.isLeftOut[static_cast<std::size_t>(standing.columns[static_cast<std::size_t>(point)])] =
          true;
  state.notes.push_back(found.size() == 1
                            ? ShownMessage{notes.one}
                            : ShownMessage{notes.many, {std::to_string(found.size())}});
}

Method poleMethod() {
  using Options = PoleOptions;
  OptionTable<Options> table;
  table.add(lengthOption("tolerance", Shown::tr("Tolerance"), 0.1, 1000,
                         Shown::tr("Points this near to the wall of a pole are of it.")),
            &Options::tolerance);
  table.add(noiseOption(), &Options::noise);
  table.add(lengthOption("most_radius", Shown::tr("Largest radius"), 0.1, 100000,
                         Shown::tr("Thicker cylinders are no poles.")),
            &Options::mostRadius);
  table.add(lengthOption("least_length", Shown::tr("Least length"), 1, 1e6,
                         Shown::tr("Shorter cylinders are no poles.")),
            &Options::leastLength);
  table.add(lengthOption("reach", Shown::tr("Reach"), 1, 1e6,
                         Shown::tr("How far around its middle a cylinder is sought.")),
            &Options::reach);
  table.add(lengthOption("gap", Shown::tr("Gap"), 0.1, 1e6,
                         Shown::tr("A pole goes on over gaps up to this.")),
            &Options::gap);
  table.add(angleOption("most_lean", Shown::tr("Largest lean"), 0, 80,
                        Shown::tr("Cylinders that lean more are no poles.")),
            &Options::mostLean);
  table.add(countOption("trials", Shown::tr("Trials"), 10, 100000,
                        Shown::tr("Cylinders that are tried at each place.")),
            &Options::trials);
  return {.name = "cylinders",
          .label = Shown::tr("Cylinders"),
          .help = Shown::tr("Leaves out straight cylinders that stand by themselves, are as thick "
                            "above as below, and end free."),
          .source = "R. Schnabel, R. Wahl, R. Klein, Computer Graphics Forum 26, 2007",
          .options = table.descriptions(),
          .seesRoot = false,
          .seesUp = true,
          .changesScale = true,
          .run = [table](PipelineState& state, const Values& values, const Progress& progress) {
            leaveOutFarPoints(state);
            const StandingPoints standing = standingOf(state);
            leaveOutAll(state, standing, polesIn(standing.positions, table.with(values), progress),
                        {Shown::tr("no pole was found"), Shown::tr("1 pole left out"),
                         Shown::tr("%1 poles left out")});
          }};
}

Method wireMethod() {
  using Options = WireOptions;
  OptionTable<Options> table;
  table.add(lengthOption("tolerance", Shown::tr("Tolerance"), 0.1, 1000,
                         Shown::tr("Points this near to the curve of a wire are of it.")),
            &Options::tolerance);
  table.add(noiseOption(), &Options::noise);
  table.add(lengthOption("least_length", Shown::tr("Least length"), 1, 1e6,
                         Shown::tr("Shorter curves are no wires.")),
            &Options::leastLength);
  table.add(lengthOption("gap", Shown::tr("Gap"), 0.1, 1e6,
                         Shown::tr("A wire goes on over gaps up to this.")),
            &Options::gap);
  table.add(ratioOption("most_sag", Shown::tr("Largest sag"), 0, 1,
                        Shown::tr("How deep a wire may hang, by its span.")),
            &Options::mostSag);
  return {.name = "catenaries",
          .label = Shown::tr("Hanging curves"),
          .help = Shown::tr("Leaves out thin curves that hang free between two ends."),
          .source = "Y. Jwa, G. Sohn, Photogrammetric Engineering & Remote Sensing 78, 2012",
          .options = table.descriptions(),
          .seesRoot = false,
          .seesUp = true,
          .changesScale = true,
          .run = [table](PipelineState& state, const Values& values, const Progress& progress) {
            leaveOutFarPoints(state);
            const StandingPoints standing = standingOf(state);
            leaveOutAll(state, standing, wiresIn(standing.positions, table.with(values), progress),
                        {Shown::tr("no wire was found"), Shown::tr("1 wire left out"),
                         Shown::tr("%1 wires left out")});
          }};
}

struct PlantOptions {
  PlantsOptions plants;
  int number = 0; // 0: the rooted one
};

/// The plant of the point nearest to the root that was chosen; without one, the largest.
std::uint32_t rootedPlant(const PipelineState& state, const StandingPoints& standing,
                          const PlantParts& parts) {
  if (!state.chosenRoot) return 1;
  const Eigen::Vector3d root = standing.fromFile(*state.chosenRoot);
  const auto nearest = std::ranges::min_element(
      parts.bases, {}, [&](const Eigen::Vector3d& base) { return (base - root).squaredNorm(); });
  return static_cast<std::uint32_t>(nearest - parts.bases.begin() + 1);
}

OptionTable<PlantOptions> plantTable() {
  using Options = PlantOptions;
  constexpr auto plants = &PlantOptions::plants;
  OptionTable<Options> table;
  table.add(countOption("number", Shown::tr("Number"), 0, 100000,
                        Shown::tr("Which plant stays, by size: 1 is the largest; 0 is the one at "
                                  "the root that was chosen, without one the largest.")),
            &Options::number);
  table.add(lengthOption("slab_from", Shown::tr("Stems from"), 0, 1e6,
                         Shown::tr("Stems are looked for from this height above the ground on.")),
            plants, &PlantsOptions::slabFrom);
  table.add(lengthOption("slab_to", Shown::tr("Stems to"), 0, 1e6,
                         Shown::tr("Stems are looked for up to this height above the ground.")),
            plants, &PlantsOptions::slabTo);
  table.add(ratioOption("least_stem", Shown::tr("Least stem"), 0, 1,
                        Shown::tr("What crosses these heights with fewer places than this share of "
                                  "the thickest stem is a twig.")),
            plants, &PlantsOptions::leastStem);
  table.add(lengthOption("together", Shown::tr("Together"), 0, 1e6,
                         Shown::tr("Stems nearer to each other than this are of one plant.")),
            plants, &PlantsOptions::together);
  table.add(
      ratioOption("one_wood", Shown::tr("One wood"), 0, 10,
                  Shown::tr("Where wood leads from one stem to another and is nowhere thinner "
                            "than this share of the thinner stem, both are one plant.")),
      plants, &PlantsOptions::oneWood);
  table.add(lengthOption("widest_gap", Shown::tr("Widest gap"), 0, 1e6,
                         Shown::tr("Parts farther off than this from all plants are of none.")),
            plants, &PlantsOptions::widestGap);
  table.add(lengthOption("voxel", Shown::tr("Cube"), 0.1, 1e4,
                         Shown::tr("Paths lead over the means of cubes of this size.")),
            plants, &PlantsOptions::voxel);
  table.add(linksOption(), plants, &PlantsOptions::neighbors);
  constexpr auto costs = &PlantsOptions::costs;
  table.add(ratioOption("power", Shown::tr("Power"), 1, 4,
                        Shown::tr("A link counts as its length to this: more shuns gaps.")),
            plants, costs, &WoodPathCosts::power);
  table.add(
      ratioOption("thinness", Shown::tr("Thinness"), 0, 10,
                  Shown::tr("A link counts by how thin the wood is there to this: more keeps "
                            "branches with their own plant where twigs of others touch them.")),
      plants, costs, &WoodPathCosts::thinness);
  table.add(ratioOption("turn", Shown::tr("Turn"), 0, 1000,
                        Shown::tr("How much a link counts more where a path turns back: 0 takes "
                                  "turns as they come.")),
            plants, costs, &WoodPathCosts::turn);
  table.add(ratioOption("least_share", Shown::tr("Least share"), 0, 1,
                        Shown::tr("Plants with less of the points of the largest are none.")),
            plants, &PlantsOptions::leastShare);
  addClothOptions(table, plants, &PlantsOptions::ground);
  return table;
}

Method plantMethod() {
  const OptionTable<PlantOptions> table = plantTable();
  return {.name = "geodesic",
          .label = Shown::tr("Nearest stem"),
          .help = Shown::tr("Keeps one plant: what is nearer to its stem, along the plants, than "
                            "to those of others."),
          .source = "S. Tao et al., ISPRS J. Photogramm. 110, 2015",
          .options = table.descriptions(),
          .seesRoot = true,
          .seesUp = true,
          .changesScale = true,
          .cutsPlot = true,
          .run = [table](PipelineState& state, const Values& values, const Progress& progress) {
            const PlantOptions options = table.with(values);
            leaveOutFarPoints(state);
            const StandingPoints standing = standingOf(state);
            const PlantParts parts = plantsOfState(state, {}, options.plants, progress);
            const auto count = static_cast<std::uint32_t>(parts.sizes.size());
            if (count == 0) {
              state.notes.push_back({Shown::tr("no stem was found, so all points are kept")});
              return;
            }
            const std::uint32_t number =
                options.number == 0 ? rootedPlant(state, standing, parts)
                                    : std::min(static_cast<std::uint32_t>(options.number), count);
            for (std::size_t i = 0; i < parts.ofPoint.size(); ++i)
              if (parts.ofPoint[i] != number)
                state.isLeftOut[static_cast<std::size_t>(standing.columns[i])] = true;
            state.notes.push_back({Shown::tr("plant %1 of %2 kept"),
                                   {std::to_string(number), std::to_string(count)}});
          }};
}

} // namespace

PlantParts plantsOfState(const PipelineState& state, const std::vector<Eigen::Vector3d>& bases,
                         const PlantsOptions& options, const Progress& progress) {
  const GroundSurface ground =
      groundBelow(allStandingOf(state).positions, options.ground, progress.part(0, 0.3));
  const StandingPoints standing = standingOf(state);
  std::vector<Eigen::Vector3d> upright;
  for (const Eigen::Vector3d& base : bases)
    upright.push_back(standing.fromFile(base));
  return plantsAbove(ground, standing.positions, upright, options, progress.part(0.3, 1));
}

PlantsOptions plantsOptionsOf(const std::vector<double>& values) {
  return plantTable().with(values).plants;
}

std::vector<Method> groundMethods() {
  return {noMethod(Shown::tr("Keeps the ground.")), groundMethod()};
}

std::vector<Method> poleMethods() {
  return {noMethod(Shown::tr("Keeps poles.")), poleMethod()};
}

std::vector<Method> wireMethods() {
  return {noMethod(Shown::tr("Keeps wires.")), wireMethod()};
}

std::vector<Method> plantMethods() {
  return {noMethod(Shown::tr("Takes all points for one plant.")), plantMethod()};
}

} // namespace espalier
