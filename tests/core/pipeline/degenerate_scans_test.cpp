// Scans of a few places with many points each, or of points on a line: no method gives a radius or
// a place that is not finite. And what the step Radius says where little can be measured.
#include "core/base/error.h"
#include "core/pipeline/pipeline.h"
#include "tests/core/pipeline/every_method.h"
#include "tests/support/cloud_of.h"
#include "tests/support/clouds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <gmock/gmock.h>
#include <initializer_list>
#include <map>
#include <utility>

namespace espalier {
namespace {

/// Places, each with how many points lie there.
using Places = std::vector<std::pair<Eigen::Vector3f, int>>;

Eigen::Matrix3Xf pointsAt(const Places& places) {
  Eigen::Index count = 0;
  for (const auto& [place, times] : places)
    count += times;
  Eigen::Matrix3Xf points(3, count);
  Eigen::Index next = 0;
  for (const auto& [place, times] : places)
    for (int i = 0; i < times; ++i)
      points.col(next++) = place;
  return points;
}

Places line(int count) {
  Places places;
  for (int i = 0; i < count; ++i)
    places.emplace_back(Eigen::Vector3f(0, 0, 0.1F * static_cast<float>(i)), 1);
  return places;
}

/// `count` places on a line with 9 points each, and two points far away: cleaning leaves out those.
Places crowds(int count) {
  Places places = {{{100, 0, 0}, 1}, {{100, 0, 0.1F}, 1}};
  for (int i = 0; i < count; ++i)
    places.emplace_back(Eigen::Vector3f(0, 0, 3 * static_cast<float>(i)), 9);
  return places;
}

const std::map<std::string, Places>& scans() {
  static const std::map<std::string, Places> all = {
      {"two places with many points, strays far away", crowds(2)},
      {"five places with many points, strays far away", crowds(5)},
      {"two places with 7 points", {{{0, 0, 0}, 7}, {{0, 0, 5}, 7}}},
      {"two places far apart", {{{0, 0, 0}, 7}, {{0, 0, 1e6F}, 7}}},
      {"many points and one", {{{0, 0, 0}, 7}, {{0.3F, 0.2F, 1}, 1}}},
      {"one place", {{{0, 0, 0}, 30}}},
      {"two points", {{{0, 0, 0}, 1}, {{0, 0, 1}, 1}}},
      {"points on a line", line(40)}};
  return all;
}

void expectFinite(const Eigen::Matrix3Xf& points, const PipelineOptions& options) {
  try {
    const Reconstruction result = Pipeline().run(test::cloudOf(points), options);
    for (const NodeId id : result.skeleton->ids()) {
      const Node& node = (*result.skeleton)[id];
      EXPECT_TRUE(std::isfinite(node.radius) && node.radius >= 0) << node.radius;
      EXPECT_TRUE(node.position.allFinite());
    }
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()).find("not finite"), std::string::npos) << error.what();
  }
}

class DegenerateScans : public testing::TestWithParam<test::StepAndMethod> {};

TEST_P(DegenerateScans, GetFiniteRadiiAndPlacesOrAreRefused) {
  const auto& [step, method] = GetParam();
  for (const auto& [name, places] : scans())
    for (const char* skeleton : {"geodesic_bins", "point_tracking"}) {
      SCOPED_TRACE(name + ", " + skeleton);
      PipelineOptions options;
      options.methods["skeleton"] = skeleton;
      options.methods[step] = method;
      expectFinite(pointsAt(places), options);
    }
}

INSTANTIATE_TEST_SUITE_P(Methods, DegenerateScans, testing::ValuesIn(test::everyMethod()),
                         [](const auto& each) {
                           return each.param.first + "_" + each.param.second;
                         });

// Two places show no radius: what the models give them is a guess, and is called one.
TEST(RadiusNote, SaysThatRadiiAreAGuess) {
  for (const char* method : {"node_count_pipe", "length_pipe"}) {
    PipelineOptions options;
    options.methods["radius"] = method;
    const Reconstruction result = Pipeline().run(test::cloudOf(pointsAt(crowds(2))), options);
    for (const NodeId id : result.skeleton->ids())
      EXPECT_GT((*result.skeleton)[id].radius, 0) << method;
    ASSERT_EQ(notesOf(result).size(), 1U) << method;
    EXPECT_TRUE(notesOf(result)[0].starts_with(
        "Radius: no radius is measured: radii are a guess; they have the exponent of published "))
        << notesOf(result)[0];
  }
}

// A pole is as thick at its tip as at its foot: no pipe model, and not one radius for all.
TEST(RadiusNote, SaysThatThePipeModelDoesNotFit) {
  const auto cloud = test::cloudOf(test::cylinder({0, 0, 0}, {0, 0, 2}, 0.1, 0.02));
  for (const char* method : {"node_count_pipe", "length_pipe"}) {
    PipelineOptions options;
    options.methods["radius"] = method;
    const Reconstruction result = Pipeline().run(cloud, options);
    ASSERT_EQ(notesOf(result).size(), 1U) << method;
    EXPECT_THAT(notesOf(result)[0], testing::HasSubstr("which fits no pipe model"));
    const Skeleton& pole = *result.skeleton;
    const auto ids = pole.ids();
    EXPECT_NEAR(pole[ids.front()].radius, 0.1, 0.03) << method;
    EXPECT_GT(pole[ids.front()].radius, 2 * pole[ids.back()].radius) << method;
  }
}

TEST(RadiusNote, StaysWhereTheResultIsAtHand) {
  const auto cloud = test::cloudOf(test::cylinder({0, 0, 0}, {0, 0, 2}, 0.1, 0.02));
  PipelineOptions options;
  options.methods["radius"] = "node_count_pipe";
  Pipeline pipeline;
  const std::vector<std::string> first = notesOf(pipeline.run(cloud, options));
  EXPECT_EQ(first.size(), 1U);
  const Reconstruction again = pipeline.run(cloud, options);
  EXPECT_FALSE(again.steps.back().isNew);
  EXPECT_EQ(notesOf(again), first);
  EXPECT_TRUE(notesOf(pipeline.run(cloud)).empty()) << "of another method";
}

} // namespace
} // namespace espalier
