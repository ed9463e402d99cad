#pragma once

#include "core/reconstruct/trace.h"

#include <functional>
#include <vector>

namespace espalier {

/// What a tool asks of the points of the scan: the path from the first place to the last.
struct TraceQuestion {
  std::vector<Eigen::Vector3d> places; // two, or more of a stroke by hand [L], frame of the file
  bool startIsFixed = false;           // a node is there
  bool endIsFixed = false;             // likewise
  bool isDrawn = false;                // by hand: the path leads through all places
  TraceOptions options;
};

/// Called on the GUI thread. At least one trace; none if the points could not be read.
using TraceAnswer = std::function<void(const std::vector<Trace>& traces)>;

} // namespace espalier
