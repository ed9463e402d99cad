#pragma once

#include "core/evaluate/registration/registration.h"
#include "core/io/formats.h"
#include "tests/app/cli/program.h"
#include "tests/support/shared_data.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

namespace espalier::test {

/// Plants in files, to be measured against each other.
class EvaluateFiles : public ::testing::Test {
protected:
  [[nodiscard]] std::string file(const std::string& name) const {
    return (folder_ / name).string();
  }

  /// A node list of these lines: vid, parent, edge, x, y, z, radius.
  [[nodiscard]] std::string plant(const std::string& name,
                                  const std::vector<std::string>& nodes) const {
    std::string text =
        "# vid\tparentid\tedgetype\tXX\tYY\tZZ\tRadius\n" + std::to_string(nodes.size()) + "\n";
    for (const std::string& node : nodes)
      text += node + "\n";
    writeBytes(file(name), text);
    return file(name);
  }

  /// A trunk of two edges and a branch, all lengths times `scale`.
  [[nodiscard]] std::string fork(const std::string& name, double scale = 1, double x = 0) const {
    const auto at = [&](double dx, double z) {
      return std::to_string(x + scale * dx) + "\t0\t" + std::to_string(scale * z) + "\t" +
             std::to_string(scale * 0.1);
    };
    return plant(name, {"1\t\t<\t" + at(0, 0), "2\t1\t<\t" + at(0, 1), "3\t2\t<\t" + at(0, 2),
                        "4\t2\t+\t" + at(1, 2)});
  }

  /// The sample, turned by some degrees.
  [[nodiscard]] std::string turnedSample(const std::string& name, double degrees,
                                         const Eigen::Vector3d& axis) const {
    const Eigen::Isometry3d turn(Eigen::AngleAxisd(degrees * std::numbers::pi / 180, axis));
    writeStructure(file(name), moved(readStructure(truth_).value.skeleton, turn));
    return file(name);
  }

  std::filesystem::path folder_ = freshFolder();
  std::string truth_ = sample("young_tree.mtg");
};

} // namespace espalier::test
