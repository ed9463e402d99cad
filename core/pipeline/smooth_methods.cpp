#include "core/contract/least_squares_surface.h"
#include "core/pipeline/contract_parts.h"
#include "core/pipeline/methods.h"
#include "core/pipeline/smoothed_scan.h"

#include <utility>

namespace espalier {
namespace {

constexpr const char* planes = "planes";
constexpr const char* spheres = "spheres";

OptionTable<LeastSquaresOptions> smoothingTable() {
  using Options = LeastSquaresOptions;
  OptionTable<Options> table;
  table.add(
      lengthOption("radius", Shown::tr("Radius"), 2, 200,
                   Shown::tr("How far around a point others count. More than the radius of the "
                             "wood leaves it as it is, less than twice the noise smooths little.")),
      &Options::radius);
  table.add(countOption("iterations", Shown::tr("Iterations"), 1, 20,
                        Shown::tr("How often points are moved, each time to the surface of where "
                                  "they are then.")),
            &Options::iterations);
  return table;
}

/// What the two methods share.
Method surfaceMethod(Method described, LocalShape shape) {
  using Options = LeastSquaresOptions;
  return contractMethod<Options>(
      std::move(described), smoothingTable(),
      [shape](const auto& points, const Options& options, const auto&, const Progress& progress) {
        return smoothedPoints(points, shape, options, progress);
      },
      [](const Options& options) {
        MethodProbe probe;
        probe.reach = options.radius * options.iterations;
        return probe;
      });
}

} // namespace

std::vector<Method> smoothMethods() {
  return {noMethod(Shown::tr("Leaves the points where they were scanned.")),
          surfaceMethod({.name = planes,
                         .label = Shown::tr("Planes"),
                         .help = Shown::tr(
                             "Moves each point to a plane that is fitted to those near it. Smooths "
                             "most; curved wood gets a little thinner."),
                         .source = "M. Alexa et al., IEEE TVCG 9(1), 2003"},
                        LocalShape::plane),
          surfaceMethod({.name = spheres,
                         .label = Shown::tr("Spheres"),
                         .help = Shown::tr(
                             "Moves each point to an algebraic sphere that is fitted to those near "
                             "it. Keeps the thickness of curved wood; smooths less than planes."),
                         .source = "G. Guennebaud, M. Gross, SIGGRAPH 2007"},
                        LocalShape::sphere)};
}

std::optional<SmoothingShape> shapeOf(const ChosenMethod& smoothing) {
  if (isNoMethod(*smoothing.method)) return std::nullopt;
  return SmoothingShape{.shape = smoothing.method->name == planes ? LocalShape::plane
                                                                  : LocalShape::sphere,
                        .options = smoothingTable().with(smoothing.values)};
}

} // namespace espalier
