#include "core/pipeline/contract_methods.h"

#include "core/contract/adaptive_geodesic.h"
#include "core/contract/adaptive_sections.h"
#include "core/contract/euclidean_ball.h"
#include "core/contract/geodesic_centroid.h"
#include "core/pipeline/contract_parts.h"

namespace espalier {
namespace {

constexpr const char* thesis = "C. Preuksakarn, PhD thesis, Montpellier 2, 2012, section 4.6";

Method geodesicCentroidMethod() {
  using Options = GeodesicCentroidOptions;
  OptionTable<Options> table;
  table.add(linksOption(), &Options::neighbors);
  table.add({.name = "radius",
             .label = "Radius",
             .kind = OptionKind::length,
             .rule = spacings(7.5),
             .minimum = 1,
             .maximum = 60,
             .help = "Each point moves to the mean of the points within this distance along the "
                     "plant. More than the radius of the thickest wood blurs twigs."},
            &Options::radius);
  table.add(circlesOption(false), &Options::fitsCircles);
  return contractMethod<Options>(
      {.name = "geodesic_centroid",
       .label = "Geodesic centroids",
       .help = "Moves each point to the mean of the points near it along the plant.",
       .source = thesis},
      table, [](const auto& points, const Options& options, const auto&, const Progress& progress) {
        return contractedToGeodesicCentroids(points, options, progress);
      });
}

struct BallOptions {
  double radius = 0;
};

Method euclideanBallMethod() {
  OptionTable<BallOptions> table;
  table.add({.name = "radius",
             .label = "Radius",
             .kind = OptionKind::length,
             .rule = spacings(6),
             .minimum = 1,
             .maximum = 400,
             .help = "Each point moves to the mean of the points within this distance in space. "
                     "More than the gap between twigs draws them together."},
            &BallOptions::radius);
  return contractMethod<BallOptions>(
      {.name = "euclidean_ball",
       .label = "Means of balls",
       .help = "Moves each point to the mean of the points near it in space.",
       .source = "Euclidean contraction of PlantScan3D"},
      table,
      [](const auto& points, const BallOptions& options, const auto&, const Progress& progress) {
        return contractedToBallMeans(points, options.radius, progress);
      });
}

constexpr Rule heights(double count) {
  return {.fixed = 0, .spacings = 0, .heights = count};
}

Option lengthOption(const char* name, const char* label, Rule rule, const char* help) {
  return {.name = name,
          .label = label,
          .kind = OptionKind::length,
          .rule = rule,
          .minimum = 0.5,
          .maximum = 400,
          .help = help};
}

Option ratioOption(const char* name, const char* label, double value, double minimum,
                   double maximum, const char* help) {
  return {.name = name,
          .label = label,
          .kind = OptionKind::ratio,
          .rule = fixedAt(value),
          .minimum = minimum,
          .maximum = maximum,
          .help = help};
}

/// How the radius follows from the density, and where directions are measured.
template <class Options>
void addAdaptive(OptionTable<Options>& table, Rule leastRadius, Rule mostRadius) {
  table.add(lengthOption("density_radius", "Density radius", spacings(3),
                         "Distance along the plant within which points are counted, to know how "
                         "dense they lie."),
            &Options::densityRadius);
  table.add(lengthOption("least_radius", "Least radius", leastRadius,
                         "Radius where the points lie thinnest, as on twigs."),
            &Options::leastRadius);
  table.add(lengthOption("most_radius", "Greatest radius", mostRadius,
                         "Radius where the points lie densest, as on the trunk."),
            &Options::mostRadius);
  table.add(ratioOption("curve", "Curve", 1, 0.1, 10,
                        "Exponent of the density between the two radii: above 1, only the densest "
                        "wood gets a great one."),
            &Options::curve);
  table.add(lengthOption("orientation_radius", "Orientation radius", heights(0.01),
                         "Distance along the plant within which its direction is measured; about "
                         "three radii of the wood."),
            &Options::orientationRadius);
}

Method adaptiveGeodesicMethod() {
  using Options = AdaptiveGeodesicOptions;
  OptionTable<Options> table;
  table.add(linksOption(), &Options::neighbors);
  addAdaptive(table, spacings(5), spacings(10));
  table.add(ratioOption("along", "Weight along", 1, 0, 100,
                        "Weight of squared lengths along the wood: above 1, balls are slices."),
            &Options::along);
  table.add(ratioOption("across", "Weight across", 1, 0, 100,
                        "Weight of squared lengths across the wood: above 1, balls are rods."),
            &Options::across);
  table.add(circlesOption(true), &Options::fitsCircles);
  return contractMethod<Options>(
      {.name = "adaptive_geodesic",
       .label = "Adaptive geodesic centroids",
       .help = "As geodesic centroids, with a radius that grows with the density of the points.",
       .source = thesis},
      table,
      [](const auto& points, Options options, const PipelineState& state,
         const Progress& progress) {
        options.densityRange = state.densityRange;
        return contractedAdaptively(points, options, progress);
      });
}

Method adaptiveSectionsMethod() {
  using Options = AdaptiveSectionOptions;
  OptionTable<Options> table;
  table.add(linksOption(), &Options::neighbors);
  // Half of a circumference must be reached: pi times the radii that PlantScan3D looks for.
  addAdaptive(table, heights(0.0157), heights(0.0628));
  table.add(lengthOption("width", "Width", spacings(1.6),
                         "Half of the thickness of a section, along the wood."),
            &Options::width);
  table.add(circlesOption(true), &Options::fitsCircles);
  return contractMethod<Options>(
      {.name = "adaptive_sections",
       .label = "Adaptive sections",
       .help = "Moves each point to the middle of the cross-section of the wood that it is on.",
       .source = "section contraction of PlantScan3D, after the thesis of C. Preuksakarn, 2012"},
      table,
      [](const auto& points, Options options, const PipelineState& state,
         const Progress& progress) {
        options.densityRange = state.densityRange;
        return contractedToSections(points, options, progress);
      });
}

} // namespace

Option linksOption() {
  return {.name = "neighbors",
          .label = "Neighbors",
          .kind = OptionKind::count,
          .rule = fixedAt(7),
          .minimum = 3,
          .maximum = 64,
          .help = "Links per point along which distances are measured."};
}

Option circlesOption(bool isOn) {
  return {.name = "circles",
          .label = "Fit circles",
          .kind = OptionKind::flag,
          .rule = fixedAt(isOn ? 1 : 0),
          .help = "Takes the center of a circle instead of the mean of the points where these "
                  "cover one side of the wood."};
}

std::vector<Method> contractMethods() {
  // A radius of 6 spacings instead of 7.5 gains T 0.022 on leafy grown plants (6 seeds) and loses
  // 0.017 on leafy structures (3); F stays within 0.001. 4 gains more on the one, and loses F 0.006
  // on the other.
  std::vector<Method> methods = {geodesicCentroidMethod(), adaptiveGeodesicMethod(),
                                 adaptiveSectionsMethod(), euclideanBallMethod()};
  for (Method& method : surfaceContractMethods())
    methods.push_back(std::move(method));
  methods.push_back(noMethod("Leaves the points where they are."));
  return methods;
}

} // namespace espalier
