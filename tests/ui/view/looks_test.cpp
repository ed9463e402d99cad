#include "tests/support/plants.h"
#include "tests/ui/view/pictures.h"
#include "tests/ui/view/stick_view.h"
#include "ui/document/review_look.h"
#include "ui/view/palette.h"
#include "ui/view/plant_view.h"

#include <QTest>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <limits>
#include <vector>

namespace espalier {
namespace {

constexpr float none = std::numeric_limits<float>::quiet_NaN();

class LooksTest : public test::StickView {
protected:
  [[nodiscard]] int count(NodeId id, const Color& color) {
    return test::countPixels(view_.picture(view_.size()), pixelOf(id), 4, color, 24);
  }
  [[nodiscard]] int count(const Eigen::Vector3d& place, const Color& color) {
    return test::countPixels(view_.picture(view_.size()), pixelOf(place), 4, color, 24);
  }
  [[nodiscard]] std::vector<NodeId> allInside() const {
    return view_.nodesInside(QPolygonF(QRectF(0, 0, 400, 300)), Depth::through);
  }
};

constexpr Color red{200, 30, 30};
constexpr Color blue{30, 30, 200};

/// Node i of category values[i].
NodeColors colors(std::vector<float> values) {
  return {std::move(values),
          {.title = "Order", .unit = {}, .categories = {{"first", red}, {"second", blue}}}};
}

TEST_F(LooksTest, DrawsAndPicksNoHiddenNodeNorItsEdges) {
  view_.setHiddenNodes({NodeId{2}});
  EXPECT_EQ(count(NodeId{2}, test::black), 0);
  EXPECT_EQ(count({0, 0, 1.5}, test::black), 0) << "the edge to its parent";
  EXPECT_EQ(count({0, 0, 2.5}, test::black), 0) << "the edge to its child";
  EXPECT_GT(count({0, 0, 0.5}, test::black), 0);
  EXPECT_FALSE(view_.pick(pixelOf(NodeId{2})).node);
  EXPECT_FALSE(view_.pick(pixelOf({0, 0, 1.5})).edge);
  EXPECT_THAT(allInside(), testing::ElementsAre(NodeId{0}, NodeId{1}, NodeId{3}, NodeId{4}));
  view_.setHiddenNodes({});
  EXPECT_EQ(allInside().size(), 5U);
  EXPECT_GT(count({0, 0, 1.5}, test::black), 0);
}

TEST_F(LooksTest, DrawsForEachEyeIfThatIsAskedFor) {
  view_.look(StandardView::isometric); // its ends are before and behind the focus
  const auto seen = [this] {
    EXPECT_TRUE(QTest::qWaitFor([&] { return view_.isStill(); }));
    return view_.grab().toImage();
  };
  const auto fringes = [](const QImage& image) { // what is red or cyan
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) {
        const QColor color = image.pixelColor(x, y);
        if (std::abs(color.red() - color.blue()) > 60) ++count;
      }
    return count;
  };
  const QImage before = seen();
  view_.setStereo(true);
  const QImage stereo = seen();
  EXPECT_GT(fringes(stereo), fringes(before) + 20);
  view_.setStereo(false);
  EXPECT_EQ(seen(), before);
}

TEST_F(LooksTest, KeepsANodeHiddenWhileItIsEdited) {
  view_.setHiddenNodes({NodeId{2}});
  SkeletonEditor editor(plant_);
  editor.setPosition(NodeId{2}, {0.5, 0, 2});
  editor.setPosition(NodeId{3}, {0.5, 0, 3});
  const SkeletonDelta delta = editor.commit();
  view_.updateSkeleton(plant_, delta);
  EXPECT_FALSE(view_.pick(pixelOf(NodeId{2})).node);
  EXPECT_EQ(view_.pick(pixelOf(NodeId{3})).node, NodeId{3});
  EXPECT_EQ(count({0.5, 0, 2.5}, test::black), 0) << "its edges";
}

TEST_F(LooksTest, ShowsAnotherSkeletonWhole) {
  view_.setHiddenNodes({NodeId{2}});
  view_.setFaded(std::vector<NodeId>{});
  view_.setNodeColors(colors({0, 0, 0, 0, 0}));
  const QImage fresh = [&] {
    PlantView other;
    other.resize(400, 300);
    other.setDark(false);
    other.setSkeleton(plant_);
    other.setCamera(view_.camera());
    return other.picture({400, 300});
  }();
  view_.setSkeleton(plant_);
  EXPECT_EQ(test::countDifferences(view_.picture({400, 300}), fresh), 0);
}

TEST_F(LooksTest, ColorsNodesAndEdgesByCategory) {
  view_.setNodeColors(colors({none, 0, 1, 1}));
  EXPECT_GT(count({0, 0, 0.5}, red), 0) << "the edge to node 1";
  EXPECT_GT(count({0, 0, 1.5}, blue), 0);
  EXPECT_GT(count({0, 0, 3.5}, test::black), 0) << "node 4 has no value";
  view_.setNodeColors(std::nullopt);
  EXPECT_EQ(count({0, 0, 0.5}, red), 0);
}

TEST_F(LooksTest, ColorsNodesByAScaleAndCutsWhatIsBeyond) {
  view_.setNodeColors(NodeColors{{0, -5, 99, 2, 2},
                                 {.title = "Error",
                                  .unit = "mm",
                                  .map = ColorMap::diverging,
                                  .from = -2,
                                  .to = 2,
                                  .categories = {}}});
  EXPECT_GT(count({0, 0, 0.5}, colorOf(ColorMap::diverging, 0, false)), 0);
  EXPECT_GT(count({0, 0, 1.5}, colorOf(ColorMap::diverging, 1, false)), 0);
}

TEST_F(LooksTest, KeepsSelectionAmberOverColors) {
  view_.setNodeColors(colors({0, 0, 0, 0, 0}));
  view_.setSelection({NodeId{2}});
  EXPECT_GT(count(NodeId{2}, palette(false).selected), 3);
}

TEST_F(LooksTest, ShowsALegendWhileNodesAreColored) {
  const QImage before = view_.picture({400, 300});
  view_.setNodeColors(colors({none, none, none, none, none}));
  const QImage during = view_.picture({400, 300});
  const QRect corner(300, 0, 100, 90);
  EXPECT_GT(test::countPixels(during.copy(corner), red, 10), 50);
  EXPECT_GT(test::countPixels(during.copy(corner), blue, 10), 50);
  EXPECT_EQ(test::countPixels(before.copy(corner), red, 10), 0);
}

TEST_F(LooksTest, FadesAllButSome) {
  view_.setFaded(std::vector<NodeId>{NodeId{1}});
  EXPECT_GT(count({0, 0, 0.5}, test::black), 0);
  EXPECT_EQ(count({0, 0, 2.5}, test::black), 0);
  EXPECT_EQ(view_.pick(pixelOf(NodeId{3})).node, NodeId{3}) << "it can still be picked";
  view_.setFaded(std::nullopt);
  EXPECT_GT(count({0, 0, 2.5}, test::black), 0);
}

// 2 is what is still read as a color beside the ground, by the contrast of WCAG 2.1.
TEST_F(LooksTest, FadesColorsWithAMeaningSoThatTheyAreStillRead) {
  for (const bool dark : {false, true}) {
    view_.setDark(dark);
    for (const ReviewState state : {ReviewState::doubtful, ReviewState::reviewed}) {
      view_.setNodeColors(NodeColors{
          {0, 0, 0, 0, 0}, {.title = {}, .unit = {}, .categories = {{{}, colorOf(state, dark)}}}});
      view_.setFaded(std::vector<NodeId>{NodeId{1}});
      const QImage image = view_.picture({400, 300});
      const auto light = [&](const QPoint& at) {
        const QColor color = image.pixelColor(at);
        const auto linear = [](double part) {
          return part <= 0.03928 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
        };
        return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) +
               0.0722 * linear(color.blueF()) + 0.05;
      };
      const QPoint place = view_.project({0, 0, 2.5})->toPoint();
      const double ground = light(place + QPoint(40, 0));
      double contrast = 1;
      for (int x = -3; x <= 3; ++x)
        contrast = std::max(
            {contrast, light(place + QPoint(x, 0)) / ground, ground / light(place + QPoint(x, 0))});
      EXPECT_GT(contrast, 2) << dark << titleOf(state).toStdString();
    }
  }
}

TEST_F(LooksTest, FadesNoChildAddedToWhatIsNotFaded) {
  view_.setFaded(std::vector<NodeId>{NodeId{4}});
  SkeletonEditor editor(plant_);
  editor.add({.position = {1, 0, 4}, .radius = 0.1, .parent = NodeId{4}});
  editor.add({.position = {1, 0, 0}, .radius = 0.1, .parent = NodeId{0}});
  const SkeletonDelta delta = editor.commit();
  view_.updateSkeleton(plant_, delta);
  EXPECT_GT(count({0.5, 0, 4}, test::black), 0);
  EXPECT_EQ(count({0.5, 0, 0}, test::black), 0);
}

/// Two points beside the stick: their columns, the left one first.
class PointLooksTest : public LooksTest {
protected:
  PointLooksTest() {
    cloud_ = test::cloudOf({left_, right_});
    view_.setCloud(cloud_);
    view_.setPointColor(PointColor::uniform);
    view_.setPointSize(6);
    leftColumn_ = cloud_->position(0).x() < 0 ? 0 : 1;
  }
  [[nodiscard]] std::shared_ptr<const std::vector<PointState>> leftIs(PointState state) const {
    std::vector<PointState> states(2, PointState::normal);
    states[leftColumn_] = state;
    return std::make_shared<const std::vector<PointState>>(std::move(states));
  }

  const Eigen::Vector3d left_{-1, 0, 2};
  const Eigen::Vector3d right_{1, 0, 2};
  std::shared_ptr<const PointCloud> cloud_;
  std::size_t leftColumn_ = 0;
};

TEST_F(PointLooksTest, DrawsAndPicksNoHiddenPoint) {
  ASSERT_GT(count(left_, test::plain), 5);
  view_.setPointStates(leftIs(PointState::hidden));
  EXPECT_EQ(count(left_, test::plain), 0);
  EXPECT_GT(count(right_, test::plain), 5);
  EXPECT_FALSE(view_.pick(pixelOf(left_)).point);
  EXPECT_TRUE(view_.pick(pixelOf(right_)).point);
  EXPECT_THAT(view_.pointsInside(QPolygonF(QRectF(0, 0, 400, 300)), Depth::through),
              testing::ElementsAre(Eigen::Index(1 - leftColumn_)));
  view_.setPointStates(nullptr);
  EXPECT_GT(count(left_, test::plain), 5);
}

TEST_F(PointLooksTest, DrawsSelectedPointsAmberAndDimOnesPale) {
  view_.setPointStates(leftIs(PointState::selected));
  EXPECT_GT(count(left_, palette(false).selected), 5);
  EXPECT_EQ(count(right_, test::plain), 0) << "the others step back";
  view_.setPointStates(leftIs(PointState::dim));
  EXPECT_EQ(count(left_, test::plain), 0);
  EXPECT_GT(count(right_, test::plain), 5);
  EXPECT_TRUE(view_.pick(pixelOf(left_)).point) << "it is there";
}

TEST_F(PointLooksTest, HidesAndDimsContractedPointsAsTheyWereScanned) {
  const Color accent = palette(false).contracted;
  auto up = std::make_shared<Eigen::Matrix3Xf>(cloud_->positions());
  up->row(2).array() += 1;
  view_.setContracted(up);
  const Eigen::Vector3d leftUp = left_ + Eigen::Vector3d(0, 0, 1);
  const Eigen::Vector3d rightUp = right_ + Eigen::Vector3d(0, 0, 1);
  ASSERT_GT(count(leftUp, accent), 5);
  view_.setPointStates(leftIs(PointState::hidden));
  EXPECT_EQ(count(leftUp, accent), 0);
  EXPECT_GT(count(rightUp, accent), 5);
  EXPECT_FALSE(view_.pick(pixelOf(leftUp)).point);
  EXPECT_TRUE(view_.pick(pixelOf(rightUp)).point);
  view_.setPointStates(leftIs(PointState::dim));
  EXPECT_EQ(count(leftUp, accent), 0);
  EXPECT_TRUE(view_.pick(pixelOf(leftUp)).point) << "it is there";
  view_.setPointStates(nullptr);
  EXPECT_GT(count(leftUp, accent), 5);
}

TEST_F(PointLooksTest, DrawsNoContractedPointWhereItWasScanned) {
  const Color accent = palette(false).contracted;
  auto places = std::make_shared<Eigen::Matrix3Xf>(cloud_->positions());
  (*places)(2, static_cast<Eigen::Index>(1 - leftColumn_)) += 1; // the right one alone
  view_.setContracted(places);
  EXPECT_GT(count(right_ + Eigen::Vector3d(0, 0, 1), accent), 5);
  EXPECT_EQ(count(left_, accent), 0);
  EXPECT_GT(count(left_, test::plain), 5) << "it was left out, and is drawn as it was scanned";
}

TEST_F(PointLooksTest, ColorsPointsByValues) {
  view_.resize(600, 300); // the color bar lies beside the points
  std::vector<float> values(2, none);
  values[leftColumn_] = 10;
  view_.setPointValues(PointValues{
      std::make_shared<const std::vector<float>>(values),
      {.title = "Distance", .unit = "mm", .map = ColorMap::cividis, .to = 10, .categories = {}}});
  EXPECT_GT(count(left_, colorOf(ColorMap::cividis, 1, false)), 5);
  EXPECT_GT(count(right_, test::plain), 5) << "it has no value";
  view_.setPointValues(std::nullopt);
  EXPECT_GT(count(left_, test::plain), 5);
}

TEST_F(PointLooksTest, ColorsAPartOfThePointsInAnotherStateByTheirValues) {
  view_.resize(600, 300); // the color bar lies beside the points
  view_.setContracted(nullptr);
  const auto column = static_cast<Eigen::Index>(leftColumn_);
  Eigen::Matrix3Xf scanned = cloud_->positions().col(column);
  const Eigen::Matrix3Xf up = scanned.colwise() + Eigen::Vector3f(0, 0, 1);
  PlantState state;
  state.contracted = std::make_shared<const Eigen::Matrix3Xf>(up);
  state.scanned = std::make_shared<const Eigen::Matrix3Xf>(scanned);
  state.points = {column};
  state.replacesPoints = true;
  view_.setState(Side::right, state);
  view_.setDivider(0);
  const Eigen::Vector3d place = left_ + Eigen::Vector3d(0, 0, 1);
  EXPECT_GT(count(place, test::paleAccent), 5);
  std::vector<float> values(2, none);
  values[leftColumn_] = 10;
  view_.setPointValues(PointValues{std::make_shared<const std::vector<float>>(values),
                                   {.title = "Displacement",
                                    .unit = "m",
                                    .map = ColorMap::cividis,
                                    .to = 10,
                                    .categories = {}}});
  EXPECT_GT(count(place, colorOf(ColorMap::cividis, 1, false)), 5);
}

TEST_F(PointLooksTest, ForgetsLooksWithTheCloud) {
  view_.setPointStates(leftIs(PointState::hidden));
  view_.setCloud(test::cloudOf({left_, right_, {0, 0, 5}})); // states would not fit
  EXPECT_GT(count(left_, test::plain), 5);
}

/// A stick beside that of the view.
Skeleton besideIt() {
  Skeleton reference = test::stick(3);
  for (const NodeId id : reference.ids())
    reference.setPosition(id, reference[id].position + Eigen::Vector3d(1, 0, 0));
  return reference;
}

TEST_F(LooksTest, DrawsTheReferenceDottedWithoutNodesAndPicksNothingOfIt) {
  const Color reference = palette(false).reference;
  view_.setReference(besideIt());
  int dots = 0; // changes between line and gap from the foot of an edge to its top
  bool wasLine = false;
  const QImage picture = view_.picture(view_.size());
  for (double z = 0.1; z < 0.9; z += 0.01) {
    const bool isLine = test::countPixels(picture, pixelOf({1, 0, z}), 0, reference, 60) > 0;
    if (isLine != wasLine) ++dots;
    wasLine = isLine;
  }
  EXPECT_GT(dots, 4);
  EXPECT_FALSE(view_.pick(pixelOf({1, 0, 1})).node);
  EXPECT_FALSE(view_.pick(pixelOf({1, 0, 0.5})).edge);
  EXPECT_EQ(count({1, 0, 1}, palette(false).selected), 0);
  view_.setReferenceSelection({NodeId{1}});
  EXPECT_GT(count({1, 0, 1}, palette(false).selected), 3);
  view_.setLayerVisible(Layer::reference, false);
  EXPECT_EQ(test::countPixels(view_.picture(view_.size()), reference), 0);
  view_.setLayerVisible(Layer::reference, true);
  view_.setReference({});
  EXPECT_EQ(test::countPixels(view_.picture(view_.size()), reference), 0);
}

TEST_F(LooksTest, ColorsTheReferenceWithTheSkeletonByOneLegend) {
  view_.setReference(besideIt());
  view_.setNodeColors(colors({0, 0, 0, 0, 0}));
  const QRect corner(200, 0, 200, 90);
  const int once = test::countPixels(view_.picture({400, 300}).copy(corner), red, 10);
  view_.setReferenceColors(colors({1, 1, 1}));
  EXPECT_GT(count({1, 0, 0.5}, blue), 0);
  EXPECT_GT(count({0, 0, 0.5}, red), 0);
  EXPECT_EQ(test::countPixels(view_.picture({400, 300}).copy(corner), red, 10), once)
      << "the legend is not drawn twice";
  view_.setReferenceColors(std::nullopt);
  EXPECT_EQ(count({1, 0, 0.5}, blue), 0);
}

TEST_F(LooksTest, FramesTheReferenceToo) {
  Skeleton far = test::stick(2);
  far.setPosition(NodeId{1}, {30, 0, 0});
  view_.setReference(far);
  EXPECT_TRUE(view_.bounds().contains(Eigen::Vector3d(30, 0, 0)));
  view_.frameAll();
  EXPECT_TRUE(QTest::qWaitFor([&] { return view_.isStill(); }));
  EXPECT_TRUE(QRectF(view_.rect()).contains(pixelOf({30, 0, 0})));
}

} // namespace
} // namespace espalier
