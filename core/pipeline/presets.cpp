#include "core/pipeline/presets.h"

#include "core/base/error.h"
#include "core/base/open_for_reading.h"
#include "core/pipeline/preset.h"

#include <algorithm>
#include <filesystem>
#include <sstream>

namespace espalier {
namespace {

/// The steps of the thesis with the defaults of its program, for scans as dense as its own. The
/// program does not say the unit of its lengths: nodes of its published results are 9 spacings
/// apart where steps were from 6 to 8, so that a unit is about 1.25 spacings. On 9 grown plants and
/// 6 scans of structures, T is 0.78 and 0.83 with it, 0.73 and 0.78 with contractions by the same
/// numbers in mm. Densities count by rank there: most points of a scan lie thin, and by range
/// nearly all would get the least radius; T 0.78 and 0.85. Its cones of 90 degrees left only one,
/// straight ahead, so they are of 80. It had no step that thins, prunes, joins, recenters, slides
/// or extends, and drew thick wood to its axis by contraction alone.
PipelineOptions thesis() {
  PipelineOptions options;
  for (const char* setting : {"thin.method=none",
                              "contract.method=adaptive_geodesic",
                              "contract.neighbors=7",
                              "contract.density_radius=12.5 spacings",
                              "contract.least_radius=12.5 spacings",
                              "contract.most_radius=31 spacings",
                              "contract.curve=1",
                              "contract.densities=rank",
                              "contract.circles=no",
                              "skeleton.method=point_tracking",
                              "skeleton.least_step=8 spacings",
                              "skeleton.greatest_step=10 spacings",
                              "skeleton.reach=2",
                              "skeleton.kill=1.2",
                              "skeleton.cone_angle=80",
                              "skeleton.thick_wood=0 spacings",
                              "join.method=none",
                              "prune.method=none",
                              "recenter.method=none",
                              "insertions.method=none",
                              "ends.method=none",
                              "radius.method=node_count_pipe"})
    options.set(setting);
  return options;
}

/// All by default but which ends stay. Neither the step Leaves nor Blades is on: on simulated
/// plants each kind is found better without them (see the manual).
PipelineOptions endsFrom(const char* leastOdds) {
  PipelineOptions options;
  options.set(std::string("prune.least_odds=") + leastOdds);
  return options;
}

/// What stands around plants is left out, and one of them is taken; all else by default.
PipelineOptions plot() {
  PipelineOptions options;
  for (const char* setting : {"ground.method=cloth", "poles.method=cylinders",
                              "wires.method=catenaries", "plant.method=geodesic"})
    options.set(setting);
  return options;
}

} // namespace

const std::vector<NamedPreset>& presets() {
  static const std::vector<NamedPreset> all = {
      {"default",
       Shown::tr("Default"),
       Shown::tr("The best of all methods; every option follows from the scan."),
       "",
       {}},
      {"thesis", Shown::tr("As in the Thesis"),
       Shown::tr("Adaptive contraction, point tracking and pipe model, with the settings of the "
                 "thesis."),
       "C. Preuksakarn, PhD thesis, Montpellier 2, 2012, sections 4.5 to 4.8", thesis()},
      {"leaves", Shown::tr("Leaves"),
       Shown::tr("For herbs, seedlings and grasses with large leaves: fewer ends, only those that "
                 "are quite probably shoots or midribs; all else as by default."),
       "", endsFrom("0.75")},
      {"bare",
       Shown::tr("Tree without Leaves"),
       Shown::tr("For trees and shrubs in winter: as by default; no other settings "
                 "were better on simulated ones."),
       "",
       {},
       PlantKind::bareTree},
      {"needles",
       Shown::tr("Tree with Needles"),
       Shown::tr("For conifers with needles: as by default; no other settings "
                 "were better on simulated ones."),
       "",
       {},
       PlantKind::needleTree},
      {"in_leaf",
       Shown::tr("Tree in Leaf"),
       Shown::tr("For trees and shrubs in leaf: as by default; no other settings "
                 "were better on simulated ones."),
       "",
       {},
       PlantKind::leafyTree},
      {"herb", Shown::tr("Herb"),
       Shown::tr("For herbs with leaves on petioles: more ends, also of those that are less "
                 "probably midribs than not."),
       "", endsFrom("0.3"), PlantKind::herb},
      {"grass",
       Shown::tr("Grass"),
       Shown::tr("For grasses such as maize: as by default; no other settings "
                 "were better on simulated ones."),
       "",
       {},
       PlantKind::grass},
      {"plot", Shown::tr("From a Plot"),
       Shown::tr("Leaves out ground, poles, wires and other plants; all else as by default."), "",
       plot()}};
  return all;
}

const NamedPreset* presetNamed(std::string_view name) {
  const auto found = std::ranges::find(presets(), name, &NamedPreset::name);
  return found == presets().end() ? nullptr : &*found;
}

std::string presetNames() {
  std::string names;
  for (const NamedPreset& each : presets())
    names += (names.empty() ? "" : ", ") + each.name;
  return names;
}

PipelineOptions presetIn(const std::string& nameOrFile, double meters) {
  if (const NamedPreset* known = presetNamed(nameOrFile)) return known->options;
  std::error_code isMissing;
  if (!std::filesystem::exists(nameOrFile, isMissing))
    throw Error(nameOrFile + ": there is no such preset or file: name " + presetNames() +
                ", or a JSON file");
  std::istringstream in(readText(nameOrFile));
  return readPreset(in, nameOrFile, meters);
}

} // namespace espalier
