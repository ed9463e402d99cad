#include "core/pipeline/method_parts.h"
#include "core/pipeline/methods.h"
#include "core/radius/assigned_radii.h"
#include "core/radius/length_pipe_model.h"
#include "core/radius/measured_radius.h"
#include "core/radius/pipe_ends.h"
#include "core/radius/wood_radii.h"

#include <algorithm>
#include <iomanip>
#include <sstream>
#include <utility>

namespace espalier {
namespace {

constexpr auto thesisLaw =
    "law of the structures published with the thesis of C. Preuksakarn, 2012";

constexpr const char* noRadii =
    Shown::tr("no radius is measured, so there are no radii: check the scan");

struct BranchOptions {
  double branchShare = 1;
};

Option branchLimitOption() {
  return ratioOption(
      "branch_limit", Shown::tr("Branch limit"), 0.1, 1,
      Shown::tr("A branch is at most this share as thick as the wood that bears it."));
}

/// Gives the nodes these radii, by id, none thicker than its parent.
void setRadii(PipelineState& state, std::vector<KnownRadius> radii, double branchShare = 1) {
  std::vector<double> free;
  free.reserve(radii.size());
  for (const KnownRadius& each : radii)
    free.push_back(each.radius);
  const std::vector<double> limited = limitedRadii(*state.skeleton, free, branchShare);
  Skeleton skeleton = *state.skeleton;
  for (const NodeId id : skeleton.ids()) {
    const std::size_t i = indexOf(id);
    RadiusOrigin& origin = radii[i].origin;
    if (limited[i] > 0) { // the interval is where it was, if the limit is not below all of it
      const double share = free[i] / limited[i];
      origin.least = static_cast<float>(std::min(1.0, share * origin.least));
      origin.most = static_cast<float>(std::min(1e6, share * origin.most));
    }
    skeleton.setRadius(id, limited[i], origin);
  }
  state.setSkeleton(std::move(skeleton));
}

/// Radii without an interval, from what the nodes carry, by id.
std::vector<KnownRadius> extrapolated(const std::vector<double>& radii) {
  std::vector<KnownRadius> known;
  known.reserve(radii.size());
  for (const double radius : radii)
    known.push_back({radius, {.source = RadiusSource::extrapolated}});
  return known;
}

/// Radii of nodes that are measured; the others follow from those next to them.
void setMeasured(PipelineState& state, const std::vector<double>& radii, double branchShare) {
  std::vector<KnownRadius> known = extrapolated(interpolatedRadii(*state.skeleton, radii));
  for (std::size_t i = 0; i < radii.size(); ++i)
    if (radii[i] > 0) known[i].origin.source = RadiusSource::measured;
  setRadii(state, std::move(known), branchShare);
}

Method assignedMethod(std::string name, std::string label, std::string help,
                      AssignedMeasure measure) {
  OptionTable<BranchOptions> table;
  table.add(branchLimitOption(), &BranchOptions::branchShare);
  return {.name = std::move(name),
          .label = std::move(label),
          .help = std::move(help),
          .source = "PlantScan3D's measures of assigned points",
          .options = table.descriptions(),
          .run = [table, measure](PipelineState& state, const Values& values,
                                  const Progress& progress) {
            const Eigen::Matrix3Xf kept = keptPositions(state);
            const AssignedPoints points(*state.skeleton, kept, state.cloud->origin(), progress);
            setMeasured(state, assignedRadii(*state.skeleton, points, measure),
                        table.with(values).branchShare);
          }};
}

/// What is done with the radii of cylinders, too.
struct CylinderMethodOptions {
  CylinderOptions cylinders;
  double branchShare = 1;
  FusionOptions fusion;
};

OptionTable<CylinderMethodOptions> cylinderTable() {
  using Options = CylinderMethodOptions;
  OptionTable<Options> table;
  table.add(coverageOption(), &Options::cylinders, &CylinderOptions::leastCoverage);
  table.add(cylinderLengthOption(), &Options::cylinders, &CylinderOptions::length);
  table.add(branchLimitOption(), &Options::branchShare);
  return table;
}

Method cylinderMethod() {
  const OptionTable<CylinderMethodOptions> table = cylinderTable();
  return {
      .name = "cylinders",
      .label = Shown::tr("Cylinder fits"),
      .help =
          Shown::tr("Radii of cylinders fitted to the wood about each node, which stray points do "
                    "not pull."),
      .source = "G. Lukacs, R. Martin, D. Marshall, ECCV 1998; coverage after P. Raumonen et "
                "al., Remote Sens. 5, 2013",
      .options = table.descriptions(),
      .run = [table](PipelineState& state, const Values& values, const Progress& progress) {
        CylinderMethodOptions options = table.with(values);
        const Eigen::Matrix3Xf kept = keptPositions(state);
        const AssignedPoints points(*state.skeleton, kept, state.cloud->origin(),
                                    progress.part(0, 0.5));
        options.cylinders.spacing = pointSpacing(kept, progress);
        std::vector<double> radii;
        for (const MeasuredRadius& each : cylinderRadii(
                 cylindersAbout(*state.skeleton, points, options.cylinders, progress.part(0.5, 1)),
                 options.cylinders.spacing))
          radii.push_back(each.radius);
        setMeasured(state, radii, options.branchShare);
      }};
}

Method fusedMethod() {
  using Options = CylinderMethodOptions;
  OptionTable<Options> table = cylinderTable();
  table.add(
      ratioOption(
          "axis_step", Shown::tr("Step along an axis"), 0.001, 10,
          Shown::tr("How much the radius may stray from the model from node to node: more follows "
                    "each measurement.")),
      &Options::fusion, &FusionOptions::axisStep);
  table.add(ratioOption("branch_step", Shown::tr("Step to a branch"), 0.001, 10,
                        Shown::tr("The same from an axis to a branch.")),
            &Options::fusion, &FusionOptions::branchStep);
  return {.name = "fused",
          .label = Shown::tr("Cylinders and pipe model"),
          .help = Shown::tr(
              "Radii of fitted cylinders where points suffice, of a pipe model fitted to them "
              "elsewhere, each as far as it can be trusted."),
          .source =
              "pipe model: K. Shinozaki et al., Jpn. J. Ecol. 14, 1964; fusion: least squares "
              "of logarithms by their deviations",
          .options = table.descriptions(),
          .run = [table](PipelineState& state, const Values& values, const Progress& progress) {
            Options options = table.with(values);
            const Eigen::Matrix3Xf kept = keptPositions(state);
            const double spacing = pointSpacing(kept, progress);
            if (!(spacing > 0)) { // all points are in one place
              state.notes.push_back({noRadii});
              return setRadii(state, std::vector<KnownRadius>(state.skeleton->idEnd()));
            }
            options.cylinders.spacing = spacing;
            const AssignedPoints points(*state.skeleton, kept, state.cloud->origin(),
                                        progress.part(0, 0.5));
            const WoodMeasurements measured =
                measuredWood(*state.skeleton, points, options.cylinders, progress.part(0.5, 1));
            const std::vector<RadiusEvidence> evidence =
                fusedWood(*state.skeleton, points, measured, spacing, options.fusion);
            setRadii(state, knownRadii(*state.skeleton, evidence, spacing), options.branchShare);
          }};
}

/// What is to be said of ends that were not both measured.
std::optional<ShownMessage> noteOf(const PipeEnds& ends) {
  const auto inShort = [](double value) {
    std::ostringstream text;
    text << std::setprecision(3) << value;
    return text.str();
  };
  const std::string exponent = inShort(publishedPipe);
  switch (ends.basis) {
  case PipeBasis::foot:
    break;
  case PipeBasis::footOnly:
    if (ends.footToTip > 0)
      return ShownMessage{
          Shown::tr("the foot measures %1 times the tips, which fits no pipe model: radii are a "
                    "guess; they have the exponent of published structures, 1/%2, from the foot "
                    "up"),
          {inShort(ends.footToTip), exponent}};
    return ShownMessage{Shown::tr("nothing is measured at the tips: radii are a guess; they have "
                                  "the exponent of published structures, 1/%1, from the foot up"),
                        {exponent}};
  case PipeBasis::tipsOnly:
    return ShownMessage{Shown::tr("nothing is measured at the foot: radii are a guess; they have "
                                  "the exponent of published structures, 1/%1, from the tips down"),
                        {exponent}};
  case PipeBasis::nothing:
    if (!(ends.radii.apexRadius > 0)) return ShownMessage{noRadii};
    return ShownMessage{Shown::tr("no radius is measured: radii are a guess; they have the "
                                  "exponent of published structures, 1/%1, from tips half as "
                                  "thick as the points are apart"),
                        {exponent}};
  }
  return std::nullopt;
}

/// What is measured, as it would be if all was known that the fusion knows: thin wood is thinner.
std::vector<MeasuredRadius> correctedWood(const Skeleton& skeleton, const AssignedPoints& points,
                                          const WoodMeasurements& wood, double spacing) {
  std::vector<MeasuredRadius> radii = wood.radii;
  if (!(spacing > 0)) return radii; // all points are in one place
  const std::vector<KnownRadius> known =
      knownRadii(skeleton, fusedWood(skeleton, points, wood, spacing), spacing);
  for (std::size_t i = 0; i < radii.size(); ++i)
    if (radii[i].radius > 0) radii[i].radius = known[i].radius;
  return radii;
}

/// The ends of a pipe model of the plant; says so if they were not both measured.
NodeCountPipeOptions pipeEndsOf(PipelineState& state, const Progress& progress) {
  const Eigen::Matrix3Xf kept = keptPositions(state);
  const Eigen::Vector3d& origin = state.cloud->origin();
  const SpatialIndex index(kept, progress.part(0, 0.1));
  const double spacing = pointSpacing(kept, index);
  const AssignedPoints points(*state.skeleton, kept, origin, progress.part(0.1, 0.5));
  const std::vector<double> lowest =
      lowestWoodRadii(*state.skeleton, {kept, origin, index, spacing}, progress.part(0.5, 0.6));
  const WoodMeasurements wood =
      measuredWood(*state.skeleton, points, {.spacing = spacing}, progress.part(0.6, 1));
  const PipeEnds ends = pipeEnds(
      *state.skeleton, lowest, correctedWood(*state.skeleton, points, wood, spacing), spacing / 2);
  if (auto note = noteOf(ends)) state.notes.push_back(*std::move(note));
  return ends.radii;
}

Method nodeCountPipeMethod() {
  return {.name = "node_count_pipe",
          .label = Shown::tr("Node-count pipe model"),
          .help = Shown::tr(
              "Radii grow with the number of nodes carried, between those measured at the foot "
              "and at the tips."),
          .source = thesisLaw,
          .options = {},
          .run = [](PipelineState& state, const Values&, const Progress& progress) {
            state.setSkeleton(withNodeCountPipeRadii(*state.skeleton, pipeEndsOf(state, progress)));
          }};
}

Method lengthPipeMethod() {
  return {.name = "length_pipe",
          .label = Shown::tr("Length pipe model"),
          .help = Shown::tr(
              "Radii grow with the length of the wood carried, between those measured at the "
              "foot and at the tips; node spacing does not matter."),
          .source = thesisLaw,
          .options = {},
          .run = [](PipelineState& state, const Values&, const Progress& progress) {
            const NodeCountPipeOptions ends = pipeEndsOf(state, progress);
            const LengthPipeModel model =
                lengthPipeThrough(*state.skeleton, ends.rootRadius, ends.apexRadius);
            setRadii(state, extrapolated(radiiOf(*state.skeleton, model)));
          }};
}

struct AveragePipeOptions {
  double exponent = 2;
};

Method averagePipeMethod() {
  OptionTable<AveragePipeOptions> table;
  table.add(ratioOption("exponent", Shown::tr("Exponent"), 0.1, 5,
                        Shown::tr("How fast radii grow with the logarithm of the length carried.")),
            &AveragePipeOptions::exponent);
  return {.name = "average_pipe",
          .label = Shown::tr("Average-constrained pipe model"),
          .help = Shown::tr(
              "Radii grow with the length of the wood carried; their mean is the mean distance "
              "of the points to the skeleton."),
          .source = "PlantScan3D; Y. Livny et al., ACM Trans. Graph. 29(6), 2010, has exponent 2.5",
          .options = table.descriptions(),
          .run = [table](PipelineState& state, const Values& values, const Progress& progress) {
            const Eigen::Matrix3Xf kept = keptPositions(state);
            const AssignedPoints points(*state.skeleton, kept, state.cloud->origin(), progress);
            double sum = 0;
            for (Eigen::Index i = 0; i < kept.cols(); ++i)
              sum += points.distance(static_cast<std::uint32_t>(i));
            const double mean = sum / static_cast<double>(kept.cols());
            setRadii(state, extrapolated(averagePipeRadii(*state.skeleton, mean,
                                                          table.with(values).exponent)));
          }};
}

} // namespace

std::vector<Method> radiusMethods() {
  // Cylinders whose points scatter by more than 1.5 errors were fitted to needles. Without them,
  // and with the lowest tenth of the distances for thin wood, not their quarter, the median error
  // of radii of 12 leafy grown plants is 0.12 instead of 0.40, of 3 leafy structures 0.17 instead
  // of 0.64, of these bare 0.074 instead of 0.099 and 0.099 instead of 0.119. The tenth alone gave
  // 0.32, 0.48, 0.092, 0.111; the cylinders alone 0.24, 0.33, 0.090, 0.111. The middle of the
  // shortest third of the distances (0.39, 0.61, 0.116, 0.113), or less trust in thin radii whose
  // distances spread (0.51, 0.83, 0.106, 0.120), gained nothing.
  return {
      fusedMethod(),
      nodeCountPipeMethod(),
      lengthPipeMethod(),
      averagePipeMethod(),
      cylinderMethod(),
      assignedMethod("mean_distance", Shown::tr("Mean distance"),
                     Shown::tr("Mean distance of the points of each node to the skeleton."),
                     AssignedMeasure::mean),
      assignedMethod("maximum_distance", Shown::tr("Maximum distance"),
                     Shown::tr("Distance that 95 % of the points of each node are nearer than."),
                     AssignedMeasure::maximum),
      assignedMethod("hull", Shown::tr("Hull"),
                     Shown::tr("Length around the convex hull of the points of each node."),
                     AssignedMeasure::hull)};
}

} // namespace espalier
