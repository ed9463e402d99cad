#include "core/pipeline/envelopes.h"

#include "core/base/error.h"
#include "core/base/shown_message.h"
#include "core/base/text.h"
#include "core/evaluate/match/comparable.h"
#include "core/graph/turn_upright.h"
#include "core/pipeline/pipeline_options.h"
#include "core/surface/envelopes/alpha_hull.h"
#include "core/surface/envelopes/asymmetric_hull.h"
#include "core/surface/envelopes/box_envelope.h"
#include "core/surface/envelopes/convex_envelope.h"
#include "core/surface/envelopes/enclosing_ball.h"
#include "core/surface/envelopes/enclosing_ellipsoid.h"
#include "core/surface/envelopes/extruded_handles.h"
#include "core/surface/envelopes/simple_solid.h"
#include "core/surface/envelopes/skinned_handles.h"
#include "core/surface/envelopes/solids_of_revolution.h"

#include <algorithm>

namespace espalier {
namespace {

/// The first options of each kind, by whose values the crown is made.
std::vector<Option> crownOptions() {
  Option within = ratioOption(
      "within", Shown::tr("Share within"), 0.8, 1,
      Shown::tr("Share of the points that the crown is made of: the outermost are left out."));
  within.rule = fixedAt(1);
  Option from = lengthOption("from", Shown::tr("From height"), 0, 20'000,
                             Shown::tr("Points lower than this above the foot are left out, as "
                                       "those of a bare stem. 0: it is about the whole plant."));
  from.rule = fixedAt(0);
  return {within, from};
}

/// What is this high above the lowest.
Eigen::Matrix3Xd placesFrom(double height, const Eigen::Matrix3Xd& places) {
  const double level = places.row(2).minCoeff() + height;
  std::vector<Eigen::Index> kept;
  for (Eigen::Index i = 0; i < places.cols(); ++i)
    if (places(2, i) >= level) kept.push_back(i);
  constexpr std::size_t fewest = 4; // that fill space
  if (kept.size() < fewest)
    throw ShownError({espalier::Shown::tr("hardly a point lies higher than \"from\", %1 above the "
                                          "foot: choose a lower height"),
                      {plainDecimal(height)}});
  return places(Eigen::all, kept);
}

/// A kind without options of its own.
EnvelopeKind kindOf(Method form, Envelope (*fit)(const Crown&, const Progress&)) {
  form.options = crownOptions();
  form.seesRoot = false;
  return {.form = std::move(form),
          .fit = [fit](const Crown& crown, const std::vector<double>&, const Progress& progress) {
            return fit(crown, progress);
          }};
}

template <class Options>
EnvelopeKind kindOf(Method form, const OptionTable<Options>& table,
                    Envelope (*fit)(const Crown&, const Options&, const Progress&)) {
  form.options = crownOptions();
  const auto own = static_cast<std::ptrdiff_t>(form.options.size()); // from there on
  form.options.insert(form.options.end(), table.descriptions().begin(), table.descriptions().end());
  form.seesRoot = false;
  return {.form = std::move(form),
          .fit = [table, fit, own](const Crown& crown, const std::vector<double>& values,
                                   const Progress& progress) {
            return fit(crown, table.with({values.begin() + own, values.end()}), progress);
          }};
}

EnvelopeKind byFormula(EnvelopeKind kind) {
  kind.hasFormula = true;
  return kind;
}

/// A kind whose envelopes are solids or hulls that have handles.
/// @param solidOf  the solid or hull that an envelope is
template <class SolidOf>
EnvelopeKind withHandles(EnvelopeKind kind, std::vector<std::string> names,
                         const SolidOf& solidOf) {
  kind.handles = std::move(names);
  kind.handling = {
      .handles = [solidOf](const Envelope& envelope) { return handlesOf(solidOf(envelope)); },
      .draggedTo =
          [solidOf](const Envelope& envelope, const std::string& handle,
                    const Eigen::Vector3d& place) {
            return draggedTo(solidOf(envelope), handle, place);
          },
      .dragged =
          [solidOf](const Envelope& envelope, const HandlePlaces& places) {
            return envelopeOf(withHandles(solidOf(envelope), places));
          }};
  return kind;
}

std::vector<std::string> namesOf(const std::vector<EnvelopeHandle>& handles) {
  std::vector<std::string> names;
  names.reserve(handles.size());
  for (const EnvelopeHandle& handle : handles)
    names.push_back(handle.name);
  return names;
}

EnvelopeKind asSolid(SimpleSolid::Kind solid, EnvelopeKind kind) {
  return withHandles(byFormula(std::move(kind)), namesOf(handlesOf(SimpleSolid{.kind = solid})),
                     [solid](const Envelope& envelope) { return simpleSolidOf(solid, envelope); });
}

std::vector<EnvelopeKind> solidKinds() {
  using Kind = SimpleSolid::Kind;
  return {
      asSolid(Kind::ball, kindOf({.name = "ball",
                                  .label = Shown::tr("Ball"),
                                  .help = Shown::tr("The smallest ball about all."),
                                  .source = "E. Welzl, 1991"},
                                 ballEnvelope)),
      asSolid(Kind::ellipsoid,
              kindOf({.name = "ellipsoid",
                      .label = Shown::tr("Ellipsoid"),
                      .help = Shown::tr("The smallest ellipsoid about all; it may lean."),
                      .source = "M. J. Todd, E. A. Yildirim, 2007"},
                     ellipsoidEnvelope)),
      asSolid(Kind::cylinder, kindOf({.name = "cylinder",
                                      .label = Shown::tr("Cylinder"),
                                      .help = Shown::tr("The smallest upright cylinder about all."),
                                      .source = "smallest circle: E. Welzl, 1991"},
                                     cylinderEnvelope)),
      asSolid(Kind::cone,
              kindOf({.name = "cone",
                      .label = Shown::tr("Cone"),
                      .help = Shown::tr("The smallest upright cone about all, its tip up."),
                      .source = "least volume over all axes and slopes"},
                     coneEnvelope)),
      asSolid(Kind::frustum,
              kindOf({.name = "frustum",
                      .label = Shown::tr("Frustum"),
                      .help = Shown::tr("The smallest upright truncated cone about all; it may "
                                        "be wider above."),
                      .source = "least volume over all axes and slopes"},
                     frustumEnvelope)),
      asSolid(Kind::paraboloid,
              kindOf({.name = "paraboloid",
                      .label = Shown::tr("Paraboloid"),
                      .help = Shown::tr("The smallest upright paraboloid about all, round above "
                                        "and flat below."),
                      .source = "least volume over all axes and slopes"},
                     paraboloidEnvelope)),
      asSolid(Kind::box,
              kindOf({.name = "box",
                      .label = Shown::tr("Box"),
                      .help = Shown::tr("The smallest upright box about all."),
                      .source = "H. Freeman, R. Shapira, 1975"},
                     [](const Crown& crown, const Progress&) { return boxEnvelope(crown); }))};
}

EnvelopeKind extrudedKind() {
  using Options = ExtrudedHullOptions;
  OptionTable<Options> table;
  table.add(flagOption("across", Shown::tr("Seen lengthwise"),
                       Shown::tr("Take the side profile along the length of the crown as seen from "
                                 "above, not across it.")),
            &Options::isAcross);
  return withHandles(
      kindOf({.name = "extruded",
              .label = Shown::tr("Extruded hull"),
              .help = Shown::tr("The outline from above, moved along the outline from the side "
                                "and scaled to it."),
              .source = "P. Birnbaum, 1997; F. Boudon, thesis, 2004, 2.1"},
             table, extrudedHull),
      extrudedHandleNames(), extrudedHullOf);
}

EnvelopeKind skinnedKind() {
  using Options = SkinnedHullOptions;
  OptionTable<Options> table;
  table.add(countOption("profiles", Shown::tr("Profiles"), 3, 72,
                        Shown::tr("How many upright profiles there are around the axis.")),
            &Options::profiles);
  return withHandles(
      kindOf({.name = "skinned",
              .label = Shown::tr("Skinned hull"),
              .help = Shown::tr("Upright profiles around an axis, with a skin drawn over them."),
              .source = "F. Boudon, thesis, 2004, 2.1"},
             table, skinnedHull),
      skinnedHandleNames(), skinnedHullOf);
}

EnvelopeKind alphaKind() {
  using Options = AlphaHullOptions;
  OptionTable<Options> table;
  table
      .add(lengthOption("radius", Shown::tr("Ball radius"), 0.5, 100'000,
                        Shown::tr("Radius of a ball that is rolled around the points: gaps that it "
                                  "goes into stay outside.")),
           &Options::radius)
      .add(flagOption("fill", Shown::tr("Fill hollows"),
                      Shown::tr("Hollows that no path leads into from outside count as inside.")),
           &Options::fillsHollows);
  return kindOf({.name = "alpha",
                 .label = Shown::tr("Alpha hull"),
                 .help = Shown::tr("What a ball cannot reach that is rolled around and among the "
                                   "points."),
                 .source = "H. Edelsbrunner, E. P. Muecke, 1994"},
                table, alphaHull);
}

std::vector<EnvelopeKind> hullKinds() {
  return {
      withHandles(byFormula(kindOf(
                      {.name = "asymmetric",
                       .label = Shown::tr("Asymmetric hull"),
                       .help = Shown::tr("A crown by its top, its bottom, its widest places to "
                                         "four sides and an exponent above and below."),
                       .source = "A. Cescatti, 1997; F. Boudon, thesis, 2004, 2.1"},
                      asymmetricEnvelope)),
                  namesOf(handlesOf(AsymmetricHull())),
                  [](const Envelope& envelope) { return asymmetricHullOf(envelope.parameters); }),
      extrudedKind(), skinnedKind(),
      kindOf({.name = "convex",
              .label = Shown::tr("Convex hull"),
              .help = Shown::tr("The smallest body about all that is hollow nowhere."),
              .source = "C. B. Barber, D. P. Dobkin, H. Huhdanpaa, 1996 (Qhull)"},
             [](const Crown& crown, const Progress&) { return convexEnvelope(crown); }),
      alphaKind()};
}

} // namespace

const std::vector<EnvelopeKind>& envelopeKinds() {
  static const std::vector<EnvelopeKind> kinds = [] {
    std::vector<EnvelopeKind> all = solidKinds();
    for (EnvelopeKind& kind : hullKinds())
      all.push_back(std::move(kind));
    return all;
  }();
  return kinds;
}

const EnvelopeKind& envelopeKindNamed(std::string_view name) {
  std::string names;
  for (const EnvelopeKind& kind : envelopeKinds()) {
    if (kind.form.name == name) return kind;
    names += (names.empty() ? "" : ", ") + kind.form.name;
  }
  throw Error("there is no envelope \"" + std::string(name) + "\": choose one of " + names);
}

Envelope envelopeAbout(const Eigen::Matrix3Xd& points, UpAxis up, const EnvelopeKind& kind,
                       const std::vector<double>& values, const Progress& progress) {
  const Eigen::Matrix3d turn = turnUpright(up);
  // Far origins cost digits; without points crownOf() says what is missing.
  const Eigen::Vector3d middle =
      points.cols() > 0 ? Eigen::Vector3d(points.rowwise().mean()) : Eigen::Vector3d::Zero();
  const Eigen::Matrix3Xd standing = turn * (points.colwise() - middle);
  const double from = values[1];
  const bool isWhole = !(from > 0) || standing.cols() == 0;
  const Progress fitting = progress.part(0, 0.3);
  const Crown crown = isWhole ? crownOf(standing, values.front(), fitting)
                              : crownOf(placesFrom(from, standing), values.front(), fitting);
  Envelope envelope = kind.fit(crown, values, progress.part(0.3, 1));
  moveEnvelope(envelope, turn.transpose(), middle);
  return envelope;
}

namespace {

/// The same with its numbers as of a plant that stands along z; its mesh is left out.
Envelope upright(const Envelope& envelope, UpAxis up) {
  Envelope turned{.mesh = {},
                  .parameters = envelope.parameters,
                  .directions = envelope.directions,
                  .profiles = envelope.profiles};
  moveEnvelope(turned, turnUpright(up), Eigen::Vector3d::Zero());
  return turned;
}

} // namespace

std::vector<EnvelopeHandle> envelopeHandles(const Envelope& envelope, UpAxis up,
                                            const EnvelopeKind& kind) {
  if (!kind.hasHandles()) return {};
  const Eigen::Matrix3d back = turnUpright(up).transpose();
  std::vector<EnvelopeHandle> handles = kind.handling.handles(upright(envelope, up));
  for (EnvelopeHandle& handle : handles) {
    handle.place = back * handle.place;
    handle.up = back * handle.up;
    handle.outward = back * handle.outward;
  }
  return handles;
}

HandlePlace draggedTo(const Envelope& envelope, UpAxis up, const EnvelopeKind& kind,
                      const std::string& handle, const Eigen::Vector3d& place) {
  return kind.handling.draggedTo(upright(envelope, up), handle, turnUpright(up) * place);
}

Envelope draggedEnvelope(const Envelope& fitted, UpAxis up, const EnvelopeKind& kind,
                         const HandlePlaces& places) {
  Envelope envelope = kind.handling.dragged(upright(fitted, up), places);
  moveEnvelope(envelope, turnUpright(up).transpose(), Eigen::Vector3d::Zero());
  return envelope;
}

Eigen::Matrix3Xd placesOf(const PointCloud& cloud, const PointSet& leftOut) {
  const std::vector<Eigen::Index> kept = others(leftOut, cloud.size());
  return cloud.positions()(Eigen::all, kept).cast<double>().colwise() + cloud.origin();
}

Eigen::Matrix3Xd placesOf(const Skeleton& skeleton) {
  const std::vector<NodeId> ids = skeleton.ids();
  Eigen::Matrix3Xd places(3, static_cast<Eigen::Index>(ids.size()));
  for (std::size_t i = 0; i < ids.size(); ++i)
    places.col(static_cast<Eigen::Index>(i)) = skeleton[ids[i]].position;
  return places;
}

PlantScale scaleOf(const Skeleton& skeleton, UpAxis up) {
  const Eigen::Matrix3Xd places = placesOf(skeleton);
  if (places.cols() == 0) return {};
  const auto along = places.row(static_cast<Eigen::Index>(up));
  return {.spacing = medianEdgeLength(skeleton), .height = along.maxCoeff() - along.minCoeff()};
}

namespace {

/// The kinds as if they were methods of a step, so that options are read and checked as theirs are.
const Step& envelopeStep() {
  static const Step step = [] {
    Step made{.name = "envelope",
              .label = Shown::tr("Envelope"),
              .help = Shown::tr("Draws a closed surface about the crown.")};
    for (const EnvelopeKind& kind : envelopeKinds())
      made.methods.push_back(kind.form);
    return made;
  }();
  return step;
}

} // namespace

std::vector<double> envelopeValues(const EnvelopeKind& kind,
                                   const std::vector<std::string>& settings,
                                   const PlantScale& scale, double meters) {
  PipelineOptions options;
  const Step& step = envelopeStep();
  options.methods[step.name] = kind.form.name;
  std::string names;
  for (const Option& option : kind.form.options)
    names += (names.empty() ? "" : ", ") + option.name;
  for (const std::string& setting : settings) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos)
      throw Error("\"" + setting + "\" sets nothing: write OPTION=VALUE, with one of " + names);
    const std::string name = setting.substr(0, equals);
    if (std::ranges::find(kind.form.options, name, &Option::name) == kind.form.options.end())
      throw Error("envelope " + kind.form.name + " has no option \"" + name + "\": choose one of " +
                  names);
    options.setText(step, name, setting.substr(equals + 1), meters);
  }
  return chosenFor(step, options, scale).values;
}

} // namespace espalier
