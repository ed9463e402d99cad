#include "core/doubt/find_doubts.h"

#include "core/decide/attachment_odds.h"
#include "core/decide/end_odds.h"
#include "core/doubt/missing_branches.h"
#include "core/doubt/plant_share.h"
#include "core/skeleton/branch_end.h"
#include "core/skeleton/length_along.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace espalier {
namespace {

constexpr double leastWrong = 0.05;
constexpr double leastAlternative = 0.02; // probability of one that is shown
constexpr std::size_t mostAlternatives = 4;

class DoubtSearch {
public:
  DoubtSearch(const Skeleton& skeleton, const DoubtSources& sources)
      : skeleton_(skeleton), sources_(sources), cloud_(*sources.distances.cloud()),
        plant_(skeleton) {}

  [[nodiscard]] std::vector<Doubt> find(const Progress& progress) {
    if (skeleton_.isEmpty() || cloud_.size() == 0) return {};
    addEnds(progress.part(0, 0.2));
    addAttachments(progress.part(0.2, 0.4));
    addMissing(progress.part(0.4, 1));
    std::vector<Doubt> doubts;
    for (auto& [node, doubt] : ofWood_)
      keep(std::move(doubt), doubts);
    for (Doubt& doubt : missing_)
      keep(std::move(doubt), doubts);
    std::ranges::stable_sort(doubts, std::greater(), &Doubt::gain);
    return doubts;
  }

private:
  using Kind = Alternative::Kind;

  void addEnds(const Progress& progress) {
    const EndsOfSkeleton ends(skeleton_, cloud_.positions(), cloud_.origin(), sources_.scale,
                              progress);
    for (const EndsOfSkeleton::End& end : ends.ends()) {
      const double shoot = probabilityOfShoot(end.evidence);
      const NodeId node = end.end.nodes.back();
      Doubt doubt{.kind = Doubt::Kind::end, .node = node};
      doubt.nodes.assign(end.end.nodes.rbegin(), end.end.nodes.rend());
      doubt.alternatives = {{.kind = Kind::asItIs, .probability = shoot},
                            {.kind = Kind::remove, .probability = 1 - shoot}};
      ofWood_[node] = std::move(doubt);
    }
  }

  /// What wood grows from; an end that is none grows from nothing.
  void addAttachments(const Progress& progress) {
    for (const AttachmentChoice& choice :
         attachmentChoices(skeleton_, sources_.index, cloud_.origin(), sources_.scale.spacing,
                           sources_.up, progress)) {
      const std::vector<double> odds = probabilitiesOf(choice);
      const auto [at, isNew] = ofWood_.try_emplace(choice.node);
      Doubt& doubt = at->second;
      if (isNew)
        doubt = {.node = choice.node,
                 .nodes = runFrom(skeleton_, choice.node),
                 .alternatives = {{.kind = Kind::asItIs, .probability = 1}}};
      const double isWood = doubt.alternatives.front().probability;
      const double isNone = 1 - isWood;
      if (isWood * (1 - odds.front()) > isNone) doubt.kind = Doubt::Kind::attachment;
      doubt.alternatives.front().probability = isWood * odds.front();
      for (std::size_t i = 1; i < choice.links.size(); ++i)
        doubt.alternatives.push_back(
            {.kind = Kind::attach, .probability = isWood * odds[i], .onto = choice.links[i].from});
    }
  }

  void addMissing(const Progress& progress) {
    for (MissingBranch& missing : missingBranches(skeleton_, sources_, progress)) {
      const double odds = probabilityOfWood(missing);
      Doubt doubt{.kind = Doubt::Kind::missing, .node = missing.branch.on};
      doubt.alternatives = {
          {.kind = Kind::asItIs, .probability = 1 - odds},
          {.kind = Kind::add, .probability = odds, .branch = std::move(missing.branch)}};
      missing_.push_back(std::move(doubt));
    }
  }

  [[nodiscard]] bool isReviewed(const Doubt& doubt) const {
    return std::ranges::any_of(doubt.nodes, [&](NodeId id) {
      return skeleton_[id].review.state == ReviewState::reviewed;
    });
  }

  /// How much of the plant an alternative would put right: of its length and of its ends, the mean.
  /// What wood carries is as it was once the wood is attached elsewhere.
  [[nodiscard]] double shareOf(const Doubt& doubt, const Alternative& one, double& length) const {
    double ends = 1;
    switch (one.kind) {
    case Kind::asItIs:
      return 0;
    case Kind::add: {
      const Skeleton& part = one.branch->part;
      length = carriedLengths(part)[indexOf(part.roots().front())];
      ends = static_cast<double>(tipCount(part));
      break;
    }
    case Kind::attach:
    case Kind::remove:
      length = lengthOf(skeleton_, doubt.nodes);
    }
    return plant_.of(length, ends);
  }

  void keep(Doubt doubt, std::vector<Doubt>& doubts) const {
    if (isReviewed(doubt)) return;
    std::erase_if(doubt.alternatives, [](const Alternative& one) {
      return one.kind != Kind::asItIs && one.probability < leastAlternative;
    });
    std::ranges::stable_sort(doubt.alternatives, std::greater(), &Alternative::probability);
    const auto present = [&] {
      return std::ranges::find(doubt.alternatives, Kind::asItIs, &Alternative::kind);
    };
    if (1 - present()->probability < leastWrong || doubt.alternatives.size() < 2) return;
    if (const auto at = present();
        at - doubt.alternatives.begin() >= std::ptrdiff_t(mostAlternatives))
      std::iter_swap(at, doubt.alternatives.begin() + mostAlternatives - 1);
    if (doubt.alternatives.size() > mostAlternatives) doubt.alternatives.resize(mostAlternatives);
    doubt.present = static_cast<std::size_t>(present() - doubt.alternatives.begin());
    for (const Alternative& one : doubt.alternatives) {
      double length = 0;
      doubt.gain += one.probability * shareOf(doubt, one, length);
      doubt.length = std::max(doubt.length, length);
    }
    doubts.push_back(std::move(doubt));
  }

  const Skeleton& skeleton_;
  const DoubtSources& sources_;
  const PointCloud& cloud_;
  PlantShare plant_;
  std::map<NodeId, Doubt> ofWood_; // by the lowest node
  std::vector<Doubt> missing_;
};

} // namespace

std::vector<Doubt> findDoubts(const Skeleton& skeleton, const DoubtSources& sources,
                              const Progress& progress) {
  progress.check();
  return DoubtSearch(skeleton, sources).find(progress);
}

} // namespace espalier
