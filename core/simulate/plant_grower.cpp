#include "core/simulate/plant_grower.h"

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/simulate/axis_growth.h"
#include "core/simulate/grown_radii.h"
#include "core/simulate/occupancy.h"

#include <queue>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

namespace espalier {
namespace {

using Eigen::Vector3d;

/// A branch that waits for its turn. Lengths in heights, as in axis_growth.
struct Bud {
  NodeId node{};
  Vector3d direction = Vector3d::UnitZ();
  double length = 1;
  double clearance = 0; // radius of the wood at `node`
  int order = 0;        // whose habit it grows by
  bool branches = true; // false: goes on from the root as its successor
  double priority = 1;  // the highest grows first
  int number = 0;       // breaks ties
};

bool growsLater(const Bud& a, const Bud& b) {
  return std::pair(a.priority, -a.number) < std::pair(b.priority, -b.number);
}

/// A plant of height about 1, grown from its longest axis to its shortest.
class Growth {
public:
  Growth(const Habit& habit, const GrowthOptions& options, double density, std::uint64_t seed)
      : habit_(habit), options_(options), density_(density), random_(seed) {
    const NodeId root = plant_.add({});
    for (int stem = 0; stem < habit.stems; ++stem)
      sow(root, stem);
  }

  /// Grows until there are enough segments. False if the buds run out before.
  bool run(const Progress& progress) {
    while (segments_ < options_.segments && !buds_.empty()) {
      const Bud bud = buds_.top();
      buds_.pop();
      growAxis(bud);
      progress.update(std::min(1.0, static_cast<double>(segments_) / options_.segments));
    }
    return segments_ >= options_.segments;
  }

  [[nodiscard]] Skeleton plant() && { return std::move(plant_); }

private:
  void sow(NodeId root, int stem) {
    const double share = habit_.stems > 1 ? static_cast<double>(stem) / (habit_.stems - 1) : 0;
    const double lean = habit_.stemLean * std::sqrt(share) + 0.04 * random_.normal();
    const double azimuth = 2.39996 * stem + 0.3 * random_.normal();
    const Vector3d direction(std::sin(lean) * std::cos(azimuth), std::sin(lean) * std::sin(azimuth),
                             std::cos(lean));
    const double length = stem == 0 ? 1 : random_.uniform(0.65, 1);
    buds_.push({root, direction, length, habit_.baseRadius, 0, stem > 0, 10 * length, sown_++});
  }

  [[nodiscard]] AxisSeed seedOf(const Bud& bud) const {
    const double spacing =
        options_.nodeSpacing > 0 ? options_.nodeSpacing / options_.height : 1.0 / 120;
    const double apex = habit_.apexRadius;
    return {.base = plant_[bud.node].position,
            .direction = bud.direction,
            .length = bud.length,
            .spacing = std::min(spacing, bud.length / 5),
            .clearance = bud.clearance,
            .baseRadius = std::min(bud.clearance,
                                   apex + (habit_.baseRadius - apex) * std::pow(bud.length, 1.2)),
            .apexRadius = apex};
  }

  void growAxis(const Bud& bud) {
    const OrderHabit& habit = habit_.order(bud.order);
    const AxisSeed seed = seedOf(bud);
    const std::vector<Sprout> sprouts = sproutsOf(habit, bud.length, density_, random_);
    const Course course = grow(seed, habit, options_.wander, sprouts, wood_, random_);
    // A branch that cannot get free of its surroundings dies.
    if (course.length < 0.4 * bud.length || course.length < 1.5 * bud.clearance) return;
    if (!plant_.children(bud.node).empty())
      segments_ += plant_.children(bud.node).size() == 1 && plant_[bud.node].parent ? 2 : 1;
    else
      segments_ += 1;
    const std::vector<NodeId> nodes = addNodes(bud, seed, course);
    addBuds(bud, habit, seed, course, sprouts, nodes);
  }

  std::vector<NodeId> addNodes(const Bud& bud, const AxisSeed& seed, const Course& course) {
    std::vector<NodeId> nodes{bud.node};
    const double step = course.length / static_cast<double>(course.positions.size() - 1);
    for (std::size_t i = 1; i < course.positions.size(); ++i) {
      nodes.push_back(
          plant_.add({.position = course.positions[i],
                      .parent = nodes.back(),
                      .edge = i == 1 && bud.branches ? EdgeType::branching : EdgeType::successor}));
      wood_.add({course.positions[i], guessedRadius(seed, step * static_cast<double>(i))});
    }
    return nodes;
  }

  void addBuds(const Bud& bud, const OrderHabit& habit, const AxisSeed& seed, const Course& course,
               const std::vector<Sprout>& sprouts, const std::vector<NodeId>& nodes) {
    const double step = course.length / static_cast<double>(nodes.size() - 1);
    for (const Sprout& sprout : sprouts) {
      const auto at = static_cast<std::size_t>(std::lround(sprout.place / step));
      if (at == 0 || at + 1 >= nodes.size()) continue; // the axis ended before it
      // Long branches and those of the trunk first, but by no means only: a plant bears short
      // shoots everywhere.
      const double rank = bud.order == 0 ? 1.5 : 1;
      const double priority = rank * std::sqrt(sprout.length) * std::exp(0.6 * random_.normal());
      buds_.push({nodes[at], course.branchDirection(at, sprout, habit.flatness), sprout.length,
                  guessedRadius(seed, sprout.place), bud.order + 1, true, priority, sown_++});
    }
  }

  const Habit& habit_;
  const GrowthOptions& options_;
  double density_;
  Random random_;
  Skeleton plant_;
  Occupancy wood_{0.04 + 2 * 0.013};
  std::priority_queue<Bud, std::vector<Bud>, decltype(&growsLater)> buds_{&growsLater};
  int sown_ = 0;
  int segments_ = 0;
};

void require(bool holds, const char* what) {
  if (!holds) throw Error(std::string("growth options: ") + what);
}

void check(const GrowthOptions& options) {
  require(options.height > 0 && std::isfinite(options.height), "expected a height above 0");
  require(options.segments >= 1 && options.segments <= 20000, "expected 1 to 20000 segments");
  require(options.nodeSpacing >= 0 && options.nodeSpacing <= options.height / 10 &&
              (options.nodeSpacing == 0 || options.nodeSpacing >= options.height / 5000),
          "expected a node spacing of 1/5000 to 1/10 of the height, or 0 for a common one");
  require(options.wander >= 0 && options.wander <= 3, "expected a wander of 0 to 3");
  require(options.baseRadius >= 0 && options.baseRadius <= options.height / 10,
          "expected a base radius of up to 1/10 of the height, or 0 for a common one");
  require(options.apexRadius >= 0, "expected an apex radius above 0, or 0 for a common one");
  require(options.radiusSpread >= 0 && options.radiusSpread <= 1,
          "expected a radius spread of 0 to 1");
}

/// The plant made as high as asked, with its root at the origin.
Skeleton scaledTo(Skeleton plant, double height) {
  double top = 0;
  for (const NodeId id : plant.ids())
    top = std::max(top, plant[id].position.z());
  for (const NodeId id : plant.ids())
    plant.setPosition(id, plant[id].position * (height / top));
  return plant;
}

} // namespace

Skeleton growPlant(const GrowthOptions& options, std::uint64_t seed, const Progress& progress) {
  check(options);
  Habit habit = options.habit.value_or(habitOf(options.architecture));
  require(habit.stems >= 1 && !habit.orders.empty(), "expected a habit with a stem");
  if (options.baseRadius > 0) habit.baseRadius = options.baseRadius / options.height;
  if (options.apexRadius > 0) habit.apexRadius = options.apexRadius / options.height;
  require(habit.apexRadius <= habit.baseRadius, "expected apices thinner than the base");

  // Where a habit has too few buds for so many segments, they stand closer.
  constexpr int attempts = 10;
  double density = 1;
  for (int attempt = 0; attempt < attempts; ++attempt, density *= 1.3) {
    Growth growth(habit, options, density, seed);
    if (!growth.run(progress.part(0.8 * attempt / attempts, 0.8 * (attempt + 1) / attempts)))
      continue;
    progress.update(0.9);
    return withGrownRadii(scaledTo(std::move(growth).plant(), options.height),
                          {.baseRadius = habit.baseRadius * options.height,
                           .apexRadius = habit.apexRadius * options.height,
                           .spread = options.radiusSpread,
                           .flare = habit.flare,
                           .seed = seed + 1});
  }
  throw Error("no room for " + std::to_string(options.segments) +
              " segments on a plant of this habit: ask for fewer");
}

} // namespace espalier
