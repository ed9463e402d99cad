#include "app/cli/doubt_numbers.h"

#include "core/doubt/doubts_of.h"
#include "core/doubt/expected_agreement.h"

#include <nlohmann/json.hpp>

namespace espalier {
namespace {

nlohmann::ordered_json toJson(const Eigen::Vector3d& place) {
  return {place.x(), place.y(), place.z()};
}

/// Places of nodes in the order of ids(), by id: so a file of the skeleton is read back.
std::vector<std::size_t> rowsOf(const Skeleton& skeleton) {
  std::vector<std::size_t> rows(skeleton.idEnd());
  std::size_t next = 0;
  for (const NodeId id : skeleton.ids())
    rows[indexOf(id)] = next++;
  return rows;
}

nlohmann::ordered_json toJson(const Alternative& one, const Skeleton& skeleton,
                              const std::vector<std::size_t>& rows) {
  nlohmann::ordered_json json = {{"kind", nameOf(one.kind)}, {"probability", one.probability}};
  if (one.onto) {
    json["onto"] = rows[indexOf(*one.onto)];
    json["onto_place"] = toJson(skeleton[*one.onto].position);
  }
  if (one.branch)
    for (const NodeId id : one.branch->part.ids())
      json["branch"].push_back(toJson(one.branch->part[id].position));
  return json;
}

nlohmann::ordered_json toJson(const Doubt& doubt, const Skeleton& skeleton,
                              const std::vector<std::size_t>& rows) {
  auto nodes = nlohmann::ordered_json::array();
  for (const NodeId id : doubt.nodes)
    nodes.push_back(rows[indexOf(id)]);
  auto alternatives = nlohmann::ordered_json::array();
  for (const Alternative& one : doubt.alternatives)
    alternatives.push_back(toJson(one, skeleton, rows));
  return {{"kind", nameOf(doubt.kind)},
          {"node", rows[indexOf(doubt.node)]},
          {"place", toJson(skeleton[doubt.node].position)},
          {"nodes", std::move(nodes)},
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
  const std::vector<std::size_t> rows = rowsOf(skeleton);
  for (const Doubt& doubt : doubts)
    list.push_back(toJson(doubt, skeleton, rows));
  return {{"expected_right", expectedAgreement(skeleton, ratings, doubts).share()},
          {"answers_for", std::move(answers)},
          {"count", doubts.size()},
          {"doubts", std::move(list)}};
}

} // namespace espalier
