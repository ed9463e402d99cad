#include "core/contract/adaptive_geodesic.h"
#include "core/contract/adaptive_sections.h"
#include "core/contract/ball_centers.h"
#include "core/contract/density_radii.h"
#include "core/contract/euclidean_ball.h"
#include "core/contract/geodesic_centroid.h"
#include "core/pipeline/contract_parts.h"
#include "core/pipeline/methods.h"

#include <algorithm>

namespace espalier {
namespace {

constexpr const char* thesisSection =
    "C. Preuksakarn, PhD thesis, Montpellier 2, 2012, section 4.6";

Option circlesOption() {
  return flagOption(
      "circles", Shown::tr("Fit circles"),
      Shown::tr("Takes the center of a circle instead of the mean of the points where these "
                "cover one side of the wood."));
}

std::optional<WoodCircle> circleOfMembers(const std::vector<Eigen::Vector3f>& members,
                                          const SeenFrom& from) {
  return circleOfBall(members, from.radius);
}

Method geodesicCentroidMethod() {
  using Options = GeodesicCentroidOptions;
  OptionTable<Options> table;
  table.add(linksOption(), &Options::neighbors, &PointLinks::count);
  table.add(
      lengthOption(
          "radius", Shown::tr("Radius"), 1, 60,
          Shown::tr("Each point moves to the mean of the points within this distance along the "
                    "plant. More than the radius of the thickest wood blurs twigs.")),
      &Options::radius);
  table.add(circlesOption(), &Options::fitsCircles);
  table.add(linkKindOption(), &Options::neighbors, &PointLinks::kind);
  return contractMethod<Options>(
      {.name = "geodesic_centroid",
       .label = Shown::tr("Geodesic centroids"),
       .help = Shown::tr("Moves each point to the mean of the points near it along the plant."),
       .inManual = Shown::tr("all plants; the default"),
       .source = thesisSection},
      table,
      [](const auto& points, const Options& options, const auto&, const Progress& progress) {
        return contractedToGeodesicCentroids(points, options, progress);
      },
      [](const Options& options) {
        MethodProbe probe = probeWithin(options.radius);
        probe.links = options.neighbors;
        probe.ball = [](const SeenPoints& seen, const SeenFrom& from) {
          return ballAlongPlant(seen, from);
        };
        if (options.fitsCircles) probe.circle = circleOfMembers;
        return probe;
      });
}

struct BallOptions {
  Length radius = spacings(6);
};

Method euclideanBallMethod() {
  OptionTable<BallOptions> table;
  table.add(
      lengthOption(
          "radius", Shown::tr("Radius"), 1, 400,
          Shown::tr("Each point moves to the mean of the points within this distance in space. "
                    "More than the gap between twigs draws them together.")),
      &BallOptions::radius);
  return contractMethod<BallOptions>(
      {.name = "euclidean_ball",
       .label = Shown::tr("Means of balls"),
       .help = Shown::tr("Moves each point to the mean of the points near it in space."),
       .inManual = Shown::tr("a quick look; twigs far apart"),
       .source = "Euclidean contraction of PlantScan3D"},
      table,
      [](const auto& points, const BallOptions& options, const auto&, const Progress& progress) {
        return contractedToBallMeans(points, options.radius, progress);
      },
      [](const BallOptions& options) { return probeWithin(options.radius); });
}

Option contractLength(const char* name, const char* label, const char* help) {
  return lengthOption(name, label, 0.5, 400, help);
}

/// How the radius follows from the density, and where directions are measured.
template <class Options> void addAdaptive(OptionTable<Options>& table) {
  table.add(contractLength("density_radius", Shown::tr("Density radius"),
                           Shown::tr("Distance along the plant within which points are counted, to "
                                     "know how dense they lie.")),
            &Options::densityRadius);
  table.add(contractLength("least_radius", Shown::tr("Least radius"),
                           Shown::tr("Radius where the points lie thinnest, as on twigs.")),
            &Options::leastRadius);
  table.add(contractLength("most_radius", Shown::tr("Greatest radius"),
                           Shown::tr("Radius where the points lie densest, as on the trunk.")),
            &Options::mostRadius);
  table.add(curveOption("curve", Shown::tr("Curve"), 0.1, 10,
                        Shown::tr("Exponent of the density between the two radii: above 1, only "
                                  "the densest wood gets a great one.")),
            &Options::curve);
  table.add(densityMeasureOption(), &Options::densityMeasure);
  table.add(contractLength("orientation_radius", Shown::tr("Orientation radius"),
                           Shown::tr("Distance along the plant within which its direction is "
                                     "measured; about three radii of the wood.")),
            &Options::orientationRadius);
}

template <class Options> MethodProbe adaptiveProbe(const Options& options) {
  const DensityRadiusOptions radii{
      .least = options.leastRadius, .most = options.mostRadius, .curve = options.curve};
  return {.links = options.neighbors,
          .reach = std::max<double>({options.densityRadius, options.leastRadius, options.mostRadius,
                                     options.orientationRadius}),
          .density =
              DensityValues{options.neighbors, options.densityRadius, options.densityMeasure},
          .radius = [radii](float density) { return radiusOfDensity(density, radii); },
          .orientationRadius = options.orientationRadius};
}

Method adaptiveGeodesicMethod() {
  using Options = AdaptiveGeodesicOptions;
  OptionTable<Options> table;
  table.add(linksOption(), &Options::neighbors, &PointLinks::count);
  addAdaptive(table);
  table.add(ratioOption(
                "along", Shown::tr("Weight along"), 0, 100,
                Shown::tr("Weight of squared lengths along the wood: above 1, balls are slices.")),
            &Options::along);
  table.add(
      ratioOption("across", Shown::tr("Weight across"), 0, 100,
                  Shown::tr("Weight of squared lengths across the wood: above 1, balls are rods.")),
      &Options::across);
  table.add(circlesOption(), &Options::fitsCircles);
  table.add(linkKindOption(), &Options::neighbors, &PointLinks::kind);
  return contractMethod<Options>(
      {.name = "adaptive_geodesic",
       .label = Shown::tr("Adaptive geodesic centroids"),
       .help = Shown::tr(
           "As geodesic centroids, with a radius that grows with the density of the points."),
       .inManual = Shown::tr("plants with thick and thin wood, scans from few sides"),
       .source = thesisSection},
      table,
      [](const auto& points, Options options, const PipelineState& state,
         const Progress& progress) {
        options.densityLevels = state.densityLevels;
        return contractedAdaptively(points, options, progress);
      },
      [](const Options& options) {
        MethodProbe probe = adaptiveProbe(options);
        probe.ball = [options](const SeenPoints& seen, const SeenFrom& from) {
          return ballAlongPlant(seen, from, options.along, options.across);
        };
        if (options.fitsCircles) probe.circle = circleOfMembers;
        return probe;
      });
}

std::optional<WoodCircle> circleOfSection(const std::vector<Eigen::Vector3f>& members,
                                          const SeenFrom& from) {
  const Eigen::Vector3f& direction = from.orientation.direction;
  if (direction.isZero()) return std::nullopt;
  return circleAround(members, direction.cast<double>().normalized(), from.radius);
}

Method adaptiveSectionsMethod() {
  using Options = AdaptiveSectionOptions;
  OptionTable<Options> table;
  table.add(linksOption(), &Options::neighbors, &PointLinks::count);
  addAdaptive(table);
  table.add(contractLength("width", Shown::tr("Width"),
                           Shown::tr("Half of the thickness of a section, along the wood.")),
            &Options::width);
  table.add(circlesOption(), &Options::fitsCircles);
  table.add(linkKindOption(), &Options::neighbors, &PointLinks::kind);
  return contractMethod<Options>(
      {.name = "adaptive_sections",
       .label = Shown::tr("Adaptive sections"),
       .help = Shown::tr(
           "Moves each point to the middle of the cross-section of the wood that it is on."),
       .inManual = Shown::tr("thick wood, trunks seen from one side"),
       .source = "section contraction of PlantScan3D, after the thesis of C. Preuksakarn, 2012"},
      table,
      [](const auto& points, Options options, const PipelineState& state,
         const Progress& progress) {
        options.densityLevels = state.densityLevels;
        return contractedToSections(points, options, progress);
      },
      [](const Options& options) {
        MethodProbe probe = adaptiveProbe(options);
        probe.reach = std::max<double>(probe.reach, options.width);
        probe.ball = [options](const SeenPoints& seen, const SeenFrom& from) {
          return sectionOfWood(seen, from, options.width);
        };
        if (options.fitsCircles) probe.circle = circleOfSection;
        return probe;
      });
}

} // namespace

std::vector<Method> contractMethods() {
  // A radius of 6 spacings instead of 7.5 gains T 0.022 on leafy grown plants (6 seeds) and loses
  // 0.017 on leafy structures (3); F stays within 0.001. 4 gains more on the one, and loses F 0.006
  // on the other.
  std::vector<Method> methods = {geodesicCentroidMethod(), adaptiveGeodesicMethod(),
                                 adaptiveSectionsMethod(), euclideanBallMethod()};
  for (Method& method : surfaceContractMethods())
    methods.push_back(std::move(method));
  methods.push_back(noMethod(Shown::tr("Leaves the points where they are.")));
  return methods;
}

} // namespace espalier
