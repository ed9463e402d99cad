// Scans that are too large to be opened whole.
#include "app/window/files/scan_part.h"
#include "core/base/error.h"
#include "core/io/formats.h"
#include "tests/app/window/project_fixture.h"
#include "ui/panels/status_line.h"

#include <QFile>
#include <QPushButton>

#include <gmock/gmock.h>

namespace espalier {
namespace {

struct ScanPartTest : test::ProjectWindowTest {
  const QString scan_ = writeScan("plot.xyz");
  const PointCloud whole_ = readPoints(toPath(scan_)).value;

  ScanPartTest() {
    QSettings(path("settings.ini"), QSettings::IniFormat).setValue("most_points_at_once", 300);
  }

  /// Of a scan with more points than are read at once, a sample of as many, as is proposed.
  void openSample() { open({scan_}, press("Open")); }
  using WindowTest::open;
  void open(const QStringList& paths, const std::function<void(QDialog&)>& reply) {
    answer(reply, [&] { open(paths); });
    waitForJob();
    waitForView();
  }

  [[nodiscard]] const PointCloud& cloud() { return *document().scan()->cloud(); }
  /// The lower half of the plant.
  [[nodiscard]] Eigen::AlignedBox3d lowerHalf() const {
    Eigen::AlignedBox3d box = whole_.bounds();
    box.max().z() = box.center().z();
    const Eigen::Vector3d margin(0.1, 0.1, 0); // no point lies on a side, where rounding decides
    return {box.min() - margin - Eigen::Vector3d(0, 0, 0.1), box.max() + margin};
  }
  [[nodiscard]] Eigen::Index pointsIn(const Eigen::AlignedBox3d& box) const {
    Eigen::Index count = 0;
    for (Eigen::Index point = 0; point < whole_.size(); ++point)
      if (box.contains(whole_.position(point))) ++count;
    return count;
  }
};

TEST_F(ScanPartTest, OpensASampleOfALargeScanAndSaysSo) {
  openSample();
  EXPECT_EQ(cloud().size(), 300);
  EXPECT_THAT(message().toStdString(),
              testing::HasSubstr("300 of " + std::to_string(whole_.size()) + " points are read"));
  EXPECT_TRUE(action("read_region").isEnabled());
  EXPECT_TRUE(window().statusLine().counts().contains("part of "));
  EXPECT_EQ(find<QPushButton>("banner_action").text(), "Read the Region in Full");
}

TEST_F(ScanPartTest, OpensOtherScansWholeWithoutAWord) {
  QSettings(path("settings.ini"), QSettings::IniFormat).remove("most_points_at_once");
  open({scan_});
  EXPECT_EQ(cloud().size(), whole_.size());
  EXPECT_FALSE(window().banner().isVisible());
  EXPECT_FALSE(window().statusLine().counts().contains("part of "));
  EXPECT_FALSE(action("read_region").isEnabled());
}

TEST_F(ScanPartTest, ReadsWhatIsInTheClippedBoxInFull) {
  QSettings(path("settings.ini"), QSettings::IniFormat).setValue("most_points_at_once", 3000);
  openSample();
  document().setUnit(LengthUnit::centimeter);
  const Eigen::AlignedBox3d box = lowerHalf();
  ASSERT_LT(pointsIn(box), 3000);
  ASSERT_GT(whole_.size(), 3000);
  view().setClip({.slab = {}, .box = box});
  action("read_region").trigger();
  waitForJob();
  EXPECT_EQ(cloud().size(), pointsIn(box));
  EXPECT_LE(cloud().bounds().max().z(), box.max().z());
  EXPECT_EQ(document().unit(), LengthUnit::centimeter) << "as it was for the sample";
  EXPECT_THAT(message().toStdString(), testing::HasSubstr("those in the box"));
}

TEST_F(ScanPartTest, AsksForAClippedBoxFirst) {
  openSample();
  clickButton("banner_action");
  EXPECT_THAT(message().toStdString(), testing::HasSubstr("clip the view to a box"));
  EXPECT_EQ(cloud().size(), 300) << "nothing was read";
}

TEST_F(ScanPartTest, AProjectFindsTheSamePointsAgain) {
  openSample();
  const Eigen::Matrix3Xf points = cloud().positions();
  const QString file = saveProject("plot.espalier");
  window().close();
  restart();
  open({file});
  ASSERT_NE(document().scan(), nullptr);
  EXPECT_EQ(cloud().positions(), points);
  EXPECT_TRUE(action("read_region").isEnabled());
  action("close_plant").trigger();
  EXPECT_FALSE(action("read_region").isEnabled());
}

TEST_F(ScanPartTest, AScanThatMovedGivesTheSamePointsAgain) {
  openSample();
  const Eigen::Matrix3Xf points = cloud().positions();
  const QString file = saveProject("plot.espalier");
  window().close();
  QDir().mkpath(path("elsewhere"));
  QFile::rename(scan_, path("elsewhere/plot.xyz"));
  restart();
  open({file});
  answer(chooseFile(path("elsewhere/plot.xyz")), [this] { clickButton("banner_action"); });
  waitForJob();
  ASSERT_NE(document().scan(), nullptr);
  EXPECT_EQ(cloud().positions(), points);
}

TEST(ScanPartText, ReadsAsItWasWritten) {
  const Eigen::AlignedBox3d box(Eigen::Vector3d(0.1, 2, 3), Eigen::Vector3d(4, 5, 1e6));
  const ScanPart part{{.most = 20'000'000, .box = box}, 5'000'000'000};
  const ScanPart read = scanPartIn(textOf(part));
  EXPECT_EQ(read.listed, part.listed);
  EXPECT_EQ(read.reading.most, part.reading.most);
  EXPECT_EQ(read.reading.box->min(), box.min());
  EXPECT_EQ(read.reading.box->max(), box.max());
  EXPECT_EQ(textOf(ScanPart()), "");
  EXPECT_FALSE(scanPartIn("").isPart());
}

TEST(ScanPartText, HoldsColumnsThatWereNamed) {
  using enum PointField;
  const std::vector<PointField> columns = {none, y, x, z, intensity, red, green, blue, station};
  const ScanPart whole{{.columns = columns}, 0};
  EXPECT_EQ(scanPartIn(textOf(whole)).reading.columns, columns);
  EXPECT_FALSE(scanPartIn(textOf(whole)).isPart());
  const ScanPart part{{.most = 5, .columns = columns}, 9};
  EXPECT_EQ(scanPartIn(textOf(part)).reading.columns, columns);
  EXPECT_EQ(scanPartIn(textOf(part)).listed, 9U);
}

TEST(ScanPartText, RefusesWhatIsNotAsItWasWritten) {
  for (const char* text :
       {"{", "{}", "{\"points_in_file\":0}", "{\"points_in_file\":9,\"most\":-1}",
        "{\"points_in_file\":9,\"box\":[[1,2,3]]}", "{\"columns\":[]}",
        "{\"columns\":[\"x\",\"leaf\"]}"})
    EXPECT_THROW((void)scanPartIn(text), Error) << text;
}

} // namespace
} // namespace espalier
