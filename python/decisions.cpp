#include "core/doubt/doubts_of.h"
#include "core/doubt/expected_agreement.h"
#include "python/arrays.h"
#include "python/bindings.h"
#include "python/held.h"
#include "python/job.h"

#include <pybind11/stl.h>

#include <optional>

namespace espalier::python {
namespace {

/// What decisions() has found. Nodes are rows of the skeleton.
struct Decisions {
  std::vector<EndDecision> ends;
  std::vector<GapDecision> gaps;
  std::vector<Doubt> doubts;
  double expectedRight = 0;
};

/// A doubt, and the skeleton that it is about.
struct HeldDoubt {
  Doubt doubt;
  HeldSkeleton skeleton;
};

struct HeldAlternative {
  Alternative alternative;
  HeldSkeleton skeleton;
};

struct HeldDecisions {
  std::shared_ptr<const Decisions> found;
  HeldSkeleton skeleton;
};

HeldDecisions decisionsOf(const HeldReconstruction& plant, int threads, const py::object& report) {
  const Reconstruction& result = *plant.result;
  auto found = std::make_shared<Decisions>();
  if (result.ends) found->ends = *result.ends;
  if (result.gaps) found->gaps = *result.gaps;
  runJob(report, threads, [&](const Progress& progress) {
    RatedDoubts rated = doubtsOf(plant.scan.cloud, result, plant.up, progress);
    if (!rated.ratings.ofEdges.empty())
      found->expectedRight =
          expectedAgreement(*result.skeleton, rated.ratings, rated.doubts).share();
    found->doubts = std::move(rated.doubts);
  });
  return {std::move(found), plant.skeleton};
}

py::array placesOf(const std::vector<Eigen::Vector3d>& places) {
  std::vector<double> numbers;
  for (const Eigen::Vector3d& place : places)
    numbers.insert(numbers.end(), place.begin(), place.end());
  return arrayOf(std::move(numbers), {std::ssize(places), 3});
}

py::array placeOf(const Eigen::Vector3d& place) {
  return arrayOf(std::vector<double>(place.begin(), place.end()), {3});
}

std::vector<std::int64_t> rowsOf(const HeldDoubt& self) {
  std::vector<std::int64_t> rows;
  for (const NodeId node : self.doubt.nodes)
    rows.push_back(self.skeleton.rows->row(node));
  return rows;
}

/// Where a branch would be that an alternative adds; none: it adds none.
py::object branchOf(const HeldAlternative& self) {
  if (!self.alternative.branch) return py::none();
  const Skeleton& part = self.alternative.branch->part;
  std::vector<Eigen::Vector3d> places;
  for (const NodeId id : part.ids())
    places.push_back(part[id].position);
  return placesOf(places);
}

void bindEnds(py::module_& module) {
  py::class_<EndDecision> end(module, "EndDecision", ofPlainType(),
                              "An end of the plant of which it was asked whether it is a shoot.");
  end.def_property_readonly(
      "path", [](const EndDecision& self) { return placesOf(self.path); },
      "(k, 3) places from its foot to its tip.");
  end.def_readonly("probability", &EndDecision::probability, "That it is a shoot, in [0, 1].");
  end.def_readonly("stays", &EndDecision::stays, "Whether the skeleton has it.");
}

void bindGaps(py::module_& module) {
  py::class_<GapAlternative> link(module, "GapAlternative", ofPlainType(), "A link across a gap.");
  link.def_property_readonly(
      "start", [](const GapAlternative& self) { return placeOf(self.from); },
      "(3,): on the wood that would bear.");
  link.def_property_readonly(
      "end", [](const GapAlternative& self) { return placeOf(self.to); },
      "(3,): on the wood that would be borne.");
  link.def_readonly("probability", &GapAlternative::probability,
                    "That the wood grew so, in [0, 1].");
  py::class_<GapDecision> gap(
      module, "GapDecision", ofPlainType(),
      "By which of several links some wood beyond a gap is attached to the rest of the plant.");
  gap.def_readonly("alternatives", &GapDecision::alternatives, "The most probable first.");
  gap.def_readonly("chosen", &GapDecision::chosen, "Which of the alternatives the skeleton has.");
  gap.def_readonly("nodes", &GapDecision::nodes, "How many nodes the wood beyond the gap had.");
}

void bindDoubts(py::module_& module) {
  py::class_<HeldAlternative> answer(module, "Alternative", ofPlainType(),
                                     "One of the answers that a doubt may have.");
  answer.def_property_readonly(
      "kind", [](const HeldAlternative& self) { return nameOf(self.alternative.kind); },
      "as_it_is, remove, attach (to `onto`) or add (`branch`).");
  answer.def_property_readonly(
      "probability", [](const HeldAlternative& self) { return self.alternative.probability; },
      "In (0, 1).");
  answer.def_property_readonly(
      "onto",
      [](const HeldAlternative& self) {
        const auto& onto = self.alternative.onto;
        return onto ? std::optional(self.skeleton.rows->row(*onto)) : std::nullopt;
      },
      "The row of the node to attach the wood to, or None.");
  answer.def_property_readonly("branch", &branchOf, "(k, 3) places of the branch to add, or None.");
  py::class_<HeldDoubt> doubt(
      module, "Doubt", ofPlainType(),
      "A place where it is not sure how the plant is. Nodes are rows of the "
      "skeleton.");
  doubt.def_property_readonly(
      "kind", [](const HeldDoubt& self) { return nameOf(self.doubt.kind); },
      "end: is this wood? attachment: what does it grow from? missing: is there a branch?");
  doubt.def_property_readonly(
      "node", [](const HeldDoubt& self) { return self.skeleton.rows->row(self.doubt.node); },
      "The lowest node of the wood in doubt, or the one that would bear what is missing.");
  doubt.def_property_readonly("nodes", &rowsOf, "The wood in doubt, an unbranched run.");
  doubt.def_property_readonly(
      "alternatives",
      [](const HeldDoubt& self) {
        std::vector<HeldAlternative> all;
        for (const Alternative& one : self.doubt.alternatives)
          all.push_back({one, self.skeleton});
        return all;
      },
      "The most probable first.");
  doubt.def_property_readonly(
      "present", [](const HeldDoubt& self) { return self.doubt.present; },
      "Which of the alternatives is as it is.");
  doubt.def_property_readonly(
      "length", [](const HeldDoubt& self) { return self.doubt.length; },
      "Of the wood in doubt, or that is missing.");
  doubt.def_property_readonly(
      "gain", [](const HeldDoubt& self) { return self.doubt.gain; },
      "How much of the plant an answer probably puts right, a share in [0, 1].");
}

} // namespace

void bindDecisions(py::module_& module) {
  bindEnds(module);
  bindGaps(module);
  bindDoubts(module);
  py::class_<HeldDecisions> decisions(
      module, "Decisions", ofPlainType(),
      "What a reconstruction decided, and what is still in doubt, with odds.");
  decisions.def_property_readonly(
      "ends", [](const HeldDecisions& self) { return self.found->ends; },
      "Ends that were asked about: those that went, then those that stay.");
  decisions.def_property_readonly(
      "gaps", [](const HeldDecisions& self) { return self.found->gaps; },
      "Gaps that were bridged.");
  decisions.def_property_readonly(
      "doubts",
      [](const HeldDecisions& self) {
        std::vector<HeldDoubt> all;
        for (const Doubt& doubt : self.found->doubts)
          all.push_back({doubt, self.skeleton});
        return all;
      },
      "What is in doubt about the skeleton, what an answer puts most right of first.");
  decisions.def_property_readonly(
      "expected_right", [](const HeldDecisions& self) { return self.found->expectedRight; },
      "The share of the length of the plant that is right, as the odds say.");
  module.def(
      "decisions", &decisionsOf, py::arg("reconstruction"), py::kw_only(), py::arg("threads") = 0,
      py::arg("progress") = py::none(),
      documented("decisions(reconstruction, *, threads=0, progress=None)",
                 "What was decided to find the skeleton, with the probabilities, and what is "
                 "in doubt about it.\n\n"
                 "threads and progress: as of reconstruct(). Takes a fifth of its time.")
          .c_str());
}

} // namespace espalier::python
