#include "core/base/random.h"
#include "core/io/formats.h"
#include "tests/app/cli/subcommands.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <gmock/gmock.h>

namespace espalier {
namespace {

using test::Outcome;
using test::runProgram;
using testing::HasSubstr;

/// A sheet of red points 10 mm apart that scatters by 3 mm, with a round hole of 90 mm, in m.
struct SmoothCommand : test::Subcommands {
  std::string sheet_;

  void SetUp() override {
    sheet_ = file("sheet.ply");
    Random random(2);
    std::vector<Eigen::Vector3d> places;
    for (int x = -30; x <= 30; ++x)
      for (int y = -30; y <= 30; ++y)
        if (std::hypot(x, y) >= 4.5)
          places.emplace_back(0.01 * x, 0.01 * y, 0.003 * random.normal());
    std::ofstream out(sheet_);
    out << "ply\nformat ascii 1.0\nelement vertex " << places.size()
        << "\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\nproperty "
           "uchar green\nproperty uchar blue\nend_header\n";
    for (const Eigen::Vector3d& place : places)
      out << place.x() << ' ' << place.y() << ' ' << place.z() << " 200 0 0\n";
  }
};

/// Root of the mean square of z.
double scatterOf(const PointCloud& cloud) {
  double sum = 0;
  for (Eigen::Index i = 0; i < cloud.size(); ++i)
    sum += cloud.position(i).z() * cloud.position(i).z();
  return std::sqrt(sum / static_cast<double>(cloud.size()));
}

TEST_F(SmoothCommand, WritesThePointsOnTheirSurface) {
  for (const char* method : {"planes", "spheres"}) {
    const Outcome outcome = runProgram({"smooth", sheet_, "-o", file("out.ply"), "--method", method,
                                        "--set", "smooth.radius=60mm", "--unit", "m"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("espalier: moved by 0.00"));
    const PointCloud smooth = readPoints(file("out.ply")).value;
    EXPECT_EQ(smooth.size(), readPoints(sheet_).value.size());
    EXPECT_LT(scatterOf(smooth), 0.0015) << method << ", of 0.003; edges are smoothed less";
    EXPECT_EQ(smooth.colors().size(), static_cast<std::size_t>(smooth.size()));
  }
}

TEST_F(SmoothCommand, FillsHolesUpToAWidth) {
  const auto added = [&](const std::string& width) {
    const Outcome outcome = runProgram({"smooth", sheet_, "-o", file("out.ply"), "--fill", width,
                                        "--unit", "m", "--json", file("out.json")});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("in holes"));
    std::ifstream json(file("out.json"));
    return nlohmann::json::parse(json)["added"].get<int>();
  };
  EXPECT_EQ(added("60mm"), 0) << "the hole is wider";
  const int count = added("110mm");
  EXPECT_GT(count, 5);
  const PointCloud filled = readPoints(file("out.ply")).value;
  EXPECT_EQ(filled.size(), readPoints(sheet_).value.size() + count);
  int inside = 0;
  for (Eigen::Index i = 0; i < filled.size(); ++i) {
    EXPECT_EQ(filled.colors()[static_cast<std::size_t>(i)], (Color{200, 0, 0}));
    if (filled.position(i).head<2>().norm() >= 0.043) continue;
    ++inside;
    EXPECT_LT(std::abs(filled.position(i).z()), 0.003);
  }
  EXPECT_EQ(inside, count) << "all new points are in the hole";
}

TEST_F(SmoothCommand, RefusesWhatItCannotDo) {
  const auto refused = [&](const std::vector<std::string>& flags, int status,
                           const std::string& message) {
    std::vector<std::string> all = {"smooth", sheet_, "-o", file("out.ply")};
    all.insert(all.end(), flags.begin(), flags.end());
    const Outcome outcome = runProgram(all);
    EXPECT_EQ(outcome.status, status) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(message));
  };
  refused({"--fill", "wide"}, 2, "--fill 'wide': write a length above 0");
  refused({"--fill", "0"}, 2, "write a length above 0");
  refused({"--fill", "5mm"}, 2, "with --unit, 50mm");
  refused({"--method", "none"}, 2, "method none smooths nothing");
  refused({"--method", "cubes"}, 2, "choose one of none, planes, spheres");
  refused({"--set", "smooth.radius=1sp"}, 1, "smooth.radius");
  EXPECT_EQ(runProgram({"smooth", sheet_, "-o", sheet_}).status, 1) << "the scan stays";
}

} // namespace
} // namespace espalier
