#pragma once

#include "ui/document/scan.h"

#include <memory>

namespace espalier::test {

/// Ten points in a line, at z = 3: for tools that need a scan, whatever it is.
inline std::unique_ptr<const Scan> lineScan() {
  RawPoints raw;
  for (int i = 0; i < 10; ++i)
    raw.positions.emplace_back(0.1 * i, 0, 3);
  return std::make_unique<const Scan>(PointCloud(std::move(raw)));
}

} // namespace espalier::test
