#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/cloud/point_cloud.h"
#include "core/io/points/read_options.h"

#include <cstdlib>
#include <iostream>
#include <sstream>
#include <string>
#include <utility>

namespace espalier::test {

/// Ends the program unless the points of a reader make the cloud that others count on.
inline void requireCloud(RawPoints points) {
  const auto isOnePerPoint = [count = points.positions.size()](std::size_t size) {
    return size == 0 || size == count;
  };
  const bool isWhole =
      isOnePerPoint(points.colors.size()) && isOnePerPoint(points.intensities.size());
  if (isWhole && PointCloud(std::move(points)).positions().allFinite()) return;
  std::cerr << "points that make no cloud\n";
  std::abort();
}

/// Ends the program unless a file gives points or an Error, be it read whole or in part.
template <auto read> void requireReads(const std::string& bytes, const char* file) {
  const Eigen::AlignedBox3d box(Eigen::Vector3d(-100, -100, -100), Eigen::Vector3d(100, 2e6, 5e6));
  for (const ReadOptions& options :
       {ReadOptions(), ReadOptions{.most = 2}, ReadOptions{.box = box}}) {
    std::istringstream in(bytes);
    try {
      requireCloud(read(in, file, options, Progress()).value);
    } catch (const Error&) { // what a broken file deserves
    }
  }
}

} // namespace espalier::test
