#include "app/cli/doubt_numbers.h"

#include "core/doubt/doubts_of.h"
#include "core/doubt/expected_agreement.h"

#include <nlohmann/json.hpp>

namespace espalier {
namespace {

nlohmann::ordered_json toJson(const Doubt& doubt, const Skeleton& skeleton) {
  auto alternatives = nlohmann::ordered_json::array();
  for (const Alternative& one : doubt.alternatives) {
    nlohmann::ordered_json json = {{"kind", nameOf(one.kind)}, {"probability", one.probability}};
    if (one.onto) json["onto"] = indexOf(*one.onto);
    alternatives.push_back(std::move(json));
  }
  const Eigen::Vector3d& place = skeleton[doubt.node].position;
  return {{"kind", nameOf(doubt.kind)},
          {"node", indexOf(doubt.node)},
          {"place", {place.x(), place.y(), place.z()}},
          {"length", doubt.length},
          {"gain", doubt.gain},
          {"present", doubt.present},
          {"alternatives", std::move(alternatives)}};
}

} // namespace

nlohmann::ordered_json doubtNumbers(const std::shared_ptr<const PointCloud>& cloud,
                                    const Reconstruction& result, UpAxis up,
                                    const Progress& progress) {
  const Skeleton& skeleton = *result.skeleton;
  if (skeleton.size() < 2 || !(result.scale.spacing > 0)) return nullptr;
  const auto [doubts, ratings] = doubtsOf(cloud, result, up, progress);
  nlohmann::ordered_json answers = nlohmann::ordered_json::object();
  for (const char* goal : {"0.9", "0.95", "0.98"}) {
    const std::size_t needed = answersFor(std::stod(goal), skeleton, ratings, doubts);
    answers[goal] =
        needed > doubts.size() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(needed);
  }
  auto list = nlohmann::ordered_json::array();
  for (const Doubt& doubt : doubts)
    list.push_back(toJson(doubt, skeleton));
  return {{"expected_right", expectedAgreement(skeleton, ratings, doubts).share()},
          {"answers_for", std::move(answers)},
          {"count", doubts.size()},
          {"doubts", std::move(list)}};
}

} // namespace espalier
