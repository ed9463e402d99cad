// What answers about one half of a plant teach about the other half, where nothing was asked.
//
//   espalier_learning SCAN REFERENCE DISTANCE ANSWERS  how far apart is near [L]; 0: the rule
//   espalier_learning --simulated FIRST COUNT ANSWERS  plants of scannedPlant(FIRST) and on
//
// A plant is reconstructed by default, and its doubts are parted at the median of where they are,
// along the axis on which they reach farthest. Of one half the program asks, what matters most
// first, and the reference answers; then the same with the halves exchanged. Of the half that was
// not asked about, with odds as they were fitted and as they are learned, are printed: how well the
// odds fit what is right (mean of minus the logarithm of the probability of what is so), the share
// of doubts of which the most probable alternative is right, and how much of the whole plant is
// right as it is, and once that half is decided by its odds.
#include "core/doubt/doubts_of.h"
#include "core/doubt/interview.h"
#include "core/evaluate/match/tolerance_curve.h"
#include "core/evaluate/registration/registration.h"
#include "core/io/formats.h"
#include "core/pipeline/pipeline.h"
#include "tests/bench/simulated_scans.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace espalier {
namespace {

/// A plant with its doubts, and what is right of each.
struct Known {
  Skeleton plant;
  Skeleton reference;
  double tolerance; // [L]
  double spacing;   // [L]
  std::vector<Doubt> doubts;
  std::vector<std::size_t> right; // alternative of each
};

struct Fitting {
  double loss = 0;    // mean
  double isRight = 0; // share of the most probable alternatives
  double share = 0;   // of the plant that is right once they are decided
  std::size_t changes = 0;
};

Known known(const std::shared_ptr<const PointCloud>& cloud, const Skeleton& reference,
            double distance, bool isRegistered) {
  const Reconstruction result = Pipeline().run(cloud, {});
  Known all{.plant = *result.skeleton,
            .reference = reference,
            .tolerance = distance > 0 ? distance : usualTolerance(reference),
            .spacing = result.scale.spacing,
            .doubts = doubtsOf(cloud, result, UpAxis::z).doubts,
            .right = {}};
  if (isRegistered)
    all.reference = moved(reference, registration(all.plant, reference, {}).motion.inverse());
  const Oracle oracle(all.reference, all.tolerance);
  for (const Doubt& doubt : all.doubts)
    all.right.push_back(oracle.answer(all.plant, doubt));
  return all;
}

/// Whether each doubt is on the far side of the middle.
std::vector<bool> sidesOf(const Known& all) {
  Eigen::Matrix3Xd places(3, static_cast<Eigen::Index>(all.doubts.size()));
  for (std::size_t i = 0; i < all.doubts.size(); ++i)
    places.col(static_cast<Eigen::Index>(i)) = all.plant[all.doubts[i].node].position;
  Eigen::Index widest = 0;
  (places.rowwise().maxCoeff() - places.rowwise().minCoeff()).maxCoeff(&widest);
  std::vector<double> along(places.row(widest).begin(), places.row(widest).end());
  const auto middle = along.begin() + static_cast<std::ptrdiff_t>(along.size() / 2);
  std::ranges::nth_element(along, middle);
  std::vector<bool> isFar;
  for (const double at : places.row(widest))
    isFar.push_back(at >= *middle);
  return isFar;
}

/// What answers to the doubts of one side teach.
LearnedOdds learnedFrom(const Known& all, const std::vector<bool>& isFar, bool side,
                        std::size_t answers) {
  std::vector<Doubt> left;
  for (std::size_t i = 0; i < all.doubts.size(); ++i)
    if (isFar[i] == side) left.push_back(all.doubts[i]);
  LearnedOdds learned;
  for (std::size_t given = 0; given < answers && !left.empty(); ++given) {
    const Doubt asked = learned.adjusted(left, all.spacing).front();
    const auto isAsked = [&](const Doubt& one) { return isSame(one, asked, 0); };
    const auto fitted = std::ranges::find_if(left, isAsked);
    const auto number = std::ranges::find_if(all.doubts, isAsked) - all.doubts.begin();
    const bool wasWrong = all.right[static_cast<std::size_t>(number)] != fitted->present;
    learned.learn(espalier::learnedFrom(*fitted, wasWrong, all.spacing));
    left.erase(fitted);
  }
  return learned;
}

/// Of the doubts of one side, with odds as they are learned.
Fitting fittingOf(const Known& all, const std::vector<bool>& isFar, bool side,
                  const LearnedOdds& learned) {
  Fitting fitting;
  std::vector<Doubt> ofSide;
  for (std::size_t i = 0; i < all.doubts.size(); ++i) {
    if (isFar[i] != side) continue;
    const Doubt doubt = learned.adjusted({all.doubts[i]}, all.spacing).front();
    const Alternative& right = all.doubts[i].alternatives[all.right[i]];
    const auto isSo = [&](const Alternative& one) {
      return one.kind == right.kind && one.onto == right.onto;
    };
    const bool isWrong = all.right[i] != all.doubts[i].present;
    fitting.loss -= std::log(isWrong ? doubt.wrong() : 1 - doubt.wrong());
    fitting.isRight += isSo(doubt.alternatives.front()) ? 1 : 0;
    ofSide.push_back(doubt);
  }
  const double count = std::max(1.0, static_cast<double>(ofSide.size()));
  fitting.loss /= count;
  fitting.isRight /= count;
  Skeleton plant = all.plant;
  SkeletonEditor editor(plant);
  fitting.changes = decideByOdds(editor, ofSide).size();
  static_cast<void>(editor.commit());
  fitting.share = agreementWith(all.reference, plant, all.tolerance).share();
  return fitting;
}

void print(const std::string& name, double asItIs, const Fitting& fitted, const Fitting& learned) {
  std::printf("%-34s %6.3f %6.3f  %6.3f %6.3f  %6.4f %6.4f %6.4f  %4zu %4zu\n", name.c_str(),
              fitted.loss, learned.loss, fitted.isRight, learned.isRight, asItIs, fitted.share,
              learned.share, fitted.changes, learned.changes);
  std::fflush(stdout);
}

struct Sum {
  double asItIs = 0;
  Fitting fitted;
  Fitting learned;
  int count = 0;
};

void add(Sum& sum, const std::string& name, const Known& all, std::size_t answers) {
  const std::vector<bool> isFar = sidesOf(all);
  const double asItIs = agreementWith(all.reference, all.plant, all.tolerance).share();
  for (const bool asked : {false, true}) {
    const Fitting fitted = fittingOf(all, isFar, !asked, {});
    const Fitting learned = fittingOf(all, isFar, !asked, learnedFrom(all, isFar, asked, answers));
    print(name + (asked ? ", near half" : ", far half"), asItIs, fitted, learned);
    const auto take = [](Fitting& to, const Fitting& from) {
      to.loss += from.loss;
      to.isRight += from.isRight;
      to.share += from.share;
      to.changes += from.changes;
    };
    take(sum.fitted, fitted);
    take(sum.learned, learned);
    sum.asItIs += asItIs;
    ++sum.count;
  }
}

void printMean(Sum sum) {
  for (Fitting* one : {&sum.fitted, &sum.learned}) {
    one->loss /= std::max(1, sum.count);
    one->isRight /= std::max(1, sum.count);
    one->share /= std::max(1, sum.count);
  }
  print("mean", sum.asItIs / std::max(1, sum.count), sum.fitted, sum.learned);
}

int run(const std::vector<std::string>& arguments) {
  if (arguments.size() != 4) {
    std::puts("espalier_learning SCAN REFERENCE DISTANCE ANSWERS\n"
              "espalier_learning --simulated FIRST COUNT ANSWERS");
    return 2;
  }
  const std::size_t answers = std::stoul(arguments[3]);
  std::printf("%-34s %13s  %13s  %20s  %9s\n", "", "loss", "most probable", "plant right",
              "changes");
  std::printf("%-34s %6s %6s  %6s %6s  %6s %6s %6s  %4s %4s\n", "half not asked about", "before",
              "after", "before", "after", "as is", "before", "after", "bef.", "aft.");
  Sum sum;
  if (arguments[0] == "--simulated") {
    const std::size_t first = std::stoul(arguments[1]);
    for (std::size_t i = first; i < first + std::stoul(arguments[2]); ++i) {
      const ScannedPlant plant = scannedPlant(i);
      const Known all = known(plant.cloud, plant.truth, 0, false);
      if (all.doubts.size() > 1) add(sum, plant.name, all, answers);
    }
  } else {
    const auto cloud = std::make_shared<const PointCloud>(readPoints(arguments[0]).value);
    const Skeleton reference = readStructure(arguments[1]).value.skeleton;
    add(sum, "scan", known(cloud, reference, std::stod(arguments[2]), true), answers);
  }
  printMean(sum);
  return 0;
}

} // namespace
} // namespace espalier

int main(int argc, char** argv) {
  return espalier::run(std::vector<std::string>(argv + 1, argv + argc));
}
