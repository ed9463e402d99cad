#include "core/clean/crop.h"
#include "core/clean/value_ranges.h"
#include "core/pipeline/clean_parts.h"
#include "core/pipeline/methods.h"

namespace espalier {
namespace {

/// @param isOutside (points upright, foot, options): one entry per point
template <class Options, class IsOutside>
Method cropMethod(const char* name, const char* label, const char* help,
                  const OptionTable<Options>& table, bool seesRoot, const IsOutside& isOutside) {
  return {
      .name = name,
      .label = label,
      .help = help,
      .source = {},
      .options = table.descriptions(),
      .seesRoot = seesRoot,
      .seesUp = true,
      .changesScale = true,
      .run = [table, isOutside, seesRoot](PipelineState& state, const Values& values,
                                          const Progress&) {
        leaveOutFarPoints(state);
        const StandingPoints standing = standingOf(state);
        if (standing.columns.empty()) return;
        const Eigen::Vector3f foot = seesRoot ? footOf(state, standing) : Eigen::Vector3f(0, 0, 0);
        leaveOut(state, standing.columns, isOutside(standing.positions, foot, table.with(values)));
      }};
}

Option sideOption(const char* name, const char* label, const char* help) {
  return lengthOption(name, label, 0, 1e7, help);
}

Method slabMethod() {
  using Options = SlabOptions;
  OptionTable<Options> table;
  table.add(sideOption("from", Shown::tr("From"),
                       Shown::tr("Points lower than this above the lowest are left out.")),
            &Options::from);
  table.add(sideOption("to", Shown::tr("To"),
                       Shown::tr("Points higher than this above the lowest are left out.")),
            &Options::to);
  return cropMethod("slab", Shown::tr("Slab"), Shown::tr("Keeps what lies between two heights."),
                    table, false,
                    [](const Eigen::Matrix3Xf& points, const Eigen::Vector3f&,
                       const Options& options) { return outsideSlab(points, options); });
}

Method distanceMethod() {
  using Options = DistanceOptions;
  OptionTable<Options> table;
  table.add(sideOption("distance", Shown::tr("Distance"),
                       Shown::tr("Points farther from the stem than this are left out; the height "
                                 "does not count.")),
            &Options::distance);
  return cropMethod("distance", Shown::tr("Distance to the stem"),
                    Shown::tr("Keeps what stands around the root that was chosen, or else around "
                              "the foot of the plant."),
                    table, true, outsideDistance);
}

Method boxMethod() {
  using Options = BoxOptions;
  OptionTable<Options> table;
  table.add(sideOption("width", Shown::tr("Width"),
                       Shown::tr("Of the box, from left to right of the front view.")),
            &Options::width);
  table.add(sideOption("depth", Shown::tr("Depth"),
                       Shown::tr("Of the box, from front to back of the front view.")),
            &Options::depth);
  table.add(sideOption("height", Shown::tr("Height"), Shown::tr("Of the box, from the root up.")),
            &Options::height);
  return cropMethod("box", Shown::tr("Box"),
                    Shown::tr("Keeps what lies in a box on the root that was chosen, or else on "
                              "the foot of the plant."),
                    table, true, outsideBox);
}

/// Leaves out by values that a scan may have.
/// @param valuesOf  of all points of a cloud; empty if it has none
template <class Options, class ValuesOf, class IsOutside>
Method valueMethod(const char* name, const char* label, const char* help, const char* source,
                   const OptionTable<Options>& table, const char* without, const ValuesOf& valuesOf,
                   const IsOutside& isOutside) {
  return {.name = name,
          .label = label,
          .help = help,
          .source = source,
          .options = table.descriptions(),
          .seesRoot = false,
          .changesScale = true,
          .run = [table, without, valuesOf, isOutside](PipelineState& state, const Values& values,
                                                       const Progress&) {
            const auto& all = valuesOf(*state.cloud);
            if (all.empty()) {
              state.notes.push_back({without});
              return;
            }
            const std::vector<bool> isOut = isOutside(all, table.with(values));
            for (std::size_t i = 0; i < isOut.size(); ++i)
              if (isOut[i]) state.isLeftOut[i] = true;
          }};
}

constexpr const char* withoutColors =
    Shown::tr("the points have no colors, so all of them are kept");

const std::vector<Color>& colorsOf(const PointCloud& cloud) {
  return cloud.colors();
}

Method intensityMethod() {
  using Options = IntensityRange;
  OptionTable<Options> table;
  table.add(ratioOption("least", Shown::tr("Least"), 0, 1,
                        Shown::tr("Points of less intensity are left out; 0 is the least of the "
                                  "scan, 1 the greatest.")),
            &Options::least);
  table.add(ratioOption("most", Shown::tr("Most"), 0, 1,
                        Shown::tr("Points of more intensity are left out.")),
            &Options::most);
  return valueMethod(
      "intensity", Shown::tr("Intensity"), Shown::tr("Keeps points by how bright they returned."),
      "", table, Shown::tr("the points have no intensities, so all of them are kept"),
      [](const PointCloud& cloud) -> const std::vector<float>& { return cloud.intensities(); },
      outsideIntensities);
}

Option channelOption(const char* name, const char* label, const char* help) {
  return countOption(name, label, 0, 255, help);
}

Method colorMethod() {
  using Options = ColorRange;
  OptionTable<Options> table;
  const char* least = Shown::tr("Points with less of this color are left out.");
  const char* most = Shown::tr("Points with more of this color are left out.");
  table.add(channelOption("least_red", Shown::tr("Least red"), least), &Options::leastRed);
  table.add(channelOption("most_red", Shown::tr("Most red"), most), &Options::mostRed);
  table.add(channelOption("least_green", Shown::tr("Least green"), least), &Options::leastGreen);
  table.add(channelOption("most_green", Shown::tr("Most green"), most), &Options::mostGreen);
  table.add(channelOption("least_blue", Shown::tr("Least blue"), least), &Options::leastBlue);
  table.add(channelOption("most_blue", Shown::tr("Most blue"), most), &Options::mostBlue);
  return valueMethod("color", Shown::tr("Color"),
                     Shown::tr("Keeps points by how red, green and blue they are."), "", table,
                     withoutColors, colorsOf, outsideColors);
}

Method hueMethod() {
  using Options = HueRange;
  OptionTable<Options> table;
  table.add(angleOption("from", Shown::tr("From"), 0, 360,
                        Shown::tr("Hues from here on are kept: 0 is red, 60 yellow, 120 green, "
                                  "240 blue.")),
            &Options::from);
  table.add(angleOption("to", Shown::tr("To"), 0, 360,
                        Shown::tr("Hues up to here are kept; less than From leads through "
                                  "red.")),
            &Options::to);
  table.add(ratioOption("least_saturation", Shown::tr("Least saturation"), 0, 1,
                        Shown::tr("Points of less colorful hues are left out.")),
            &Options::leastSaturation);
  return valueMethod("hue", Shown::tr("Hue"), Shown::tr("Keeps points by their hue."),
                     "A. R. Smith, SIGGRAPH 1978", table, withoutColors, colorsOf, outsideHues);
}

Method greennessMethod() {
  using Options = GreennessRange;
  OptionTable<Options> table;
  table.add(ratioOption("least", Shown::tr("Least"), -1, 2,
                        Shown::tr("Points that are less green are left out; grays have 0.")),
            &Options::least);
  table.add(ratioOption("most", Shown::tr("Most"), -1, 2,
                        Shown::tr("Points that are greener are left out: 0.1 leaves out leaves.")),
            &Options::most);
  return valueMethod("greenness", Shown::tr("Greenness"),
                     Shown::tr("Keeps points by how much greener than red and blue they are."),
                     "D. M. Woebbecke et al., Trans. ASAE 38, 1995", table, withoutColors, colorsOf,
                     outsideGreenness);
}

} // namespace

std::vector<Method> cropMethods() {
  return {noMethod(Shown::tr("Crops nothing.")), slabMethod(), distanceMethod(), boxMethod()};
}

std::vector<Method> valueMethods() {
  return {noMethod(Shown::tr("Looks at no values of points.")), intensityMethod(), colorMethod(),
          hueMethod(), greennessMethod()};
}

} // namespace espalier
