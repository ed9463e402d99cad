#pragma once

#include "core/mtg/structure.h"
#include "core/pipeline/pipeline.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace espalier::python {

// What objects of Python hold: values of core, shared with the arrays that are views of them.

struct HeldScan {
  std::shared_ptr<const PointCloud> cloud;
  std::vector<std::string> notes;
};

/// A skeleton as arrays have it, a row for each node, parents before their children.
struct NodeRows {
  std::vector<std::uint32_t> ids;
  std::vector<std::int64_t> rowOf; // by id; -1: no node
  std::vector<double> positions;   // 3 of each node [L]
  std::vector<double> radii;       // [L]
  std::vector<std::int64_t> parents;
  std::u32string edges;

  explicit NodeRows(const Skeleton& skeleton);
  [[nodiscard]] std::int64_t row(NodeId id) const { return rowOf[indexOf(id)]; }
};

struct HeldSkeleton {
  std::shared_ptr<const Skeleton> skeleton;
  std::shared_ptr<const MtgFrame> frame = nullptr; // null: it came from no MTG
  std::vector<std::string> notes = {};
  std::shared_ptr<const NodeRows> rows = std::make_shared<const NodeRows>(*skeleton);
};

struct HeldReconstruction {
  HeldScan scan;
  UpAxis up = UpAxis::z;
  std::shared_ptr<const Reconstruction> result;
  HeldSkeleton skeleton;
};

} // namespace espalier::python
