// What the plant of a scan probably is, is said in the panel of the pipeline.
#include "core/pipeline/kind_of_scan.h"
#include "tests/app/window/project_fixture.h"
#include "tests/support/leafy_plants.h"
#include "ui/panels/kind_line.h"

#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QRegularExpression>
#include <QTest>
#include <QTextStream>

namespace espalier {
namespace {

struct KindTest : test::ProjectWindowTest {
  QString writeLeafyHerb(const QString& name) const { return write(name, test::leafyHerb().cloud); }
  QString write(const QString& name, const PointCloud& cloud) const {
    QFile file(path(name));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    QTextStream text(&file);
    for (Eigen::Index i = 0; i < cloud.size(); ++i) {
      const Eigen::Vector3d place = cloud.position(i);
      text << place.x() << ' ' << place.y() << ' ' << place.z() << '\n';
    }
    return file.fileName();
  }
  [[nodiscard]] bool isSaid() { return find<KindLine>("kind_line").isVisible(); }
  [[nodiscard]] bool waitUntilSaid() {
    return QTest::qWaitFor([&] { return isSaid(); }, patience);
  }
};

TEST_F(KindTest, IsSaidBeforeTheFirstReconstructionAndTakesNothingByItself) {
  EXPECT_FALSE(action("take_kind").isEnabled());
  open({writeLeafyHerb("herb.xyz")});
  ASSERT_TRUE(waitUntilSaid());
  EXPECT_TRUE(find<QLabel>("kind_text").text().contains(QRegularExpression(": Herb \\(\\d+.%\\)$")))
      << find<QLabel>("kind_text").text().toStdString();
  EXPECT_TRUE(find<QLabel>("kind_text").toolTip().contains("% of blades"));
  EXPECT_TRUE(options().settings.empty()) << "nothing is chosen by itself";
  action("reconstruct").trigger();
  waitForJob();
  EXPECT_FALSE(isSaid());
  EXPECT_TRUE(action("take_kind").isEnabled()) << "for who goes on to look for settings";
  action("undo").trigger();
  EXPECT_TRUE(isSaid());
}

TEST_F(KindTest, ItsSettingsAreTakenByOneClick) {
  open({writeLeafyHerb("herb.xyz")});
  ASSERT_TRUE(waitUntilSaid());
  const PipelineOptions& wanted = presetFor(PlantKind::herb).options;
  ASSERT_NE(options().settings, wanted.settings);
  clickButton("kind_take");
  EXPECT_EQ(options().settings, wanted.settings);
  EXPECT_EQ(options().methods, wanted.methods);
  const QString said = find<QLabel>("kind_text").text();
  EXPECT_TRUE(said.startsWith("Perhaps: Herb (")) << said.toStdString();
  EXPECT_TRUE(said.endsWith(". The settings are those for it")) << said.toStdString();
  EXPECT_FALSE(find<QPushButton>("kind_take").isVisible()) << "nothing is left to be taken";
  action("preset_default").trigger();
  EXPECT_TRUE(find<QLabel>("kind_text").text().endsWith("%)"));
  EXPECT_TRUE(find<QPushButton>("kind_take").isVisible());
}

TEST_F(KindTest, IsOfTheScanThatIsOpen) {
  open({writeLeafyHerb("herb.xyz")});
  ASSERT_TRUE(waitUntilSaid());
  const QString before = find<QLabel>("kind_text").text();
  open({writeScan("tree.xyz")});
  ASSERT_TRUE(waitUntilSaid());
  EXPECT_NE(find<QLabel>("kind_text").text(), before);
  action("new_plant").trigger();
  EXPECT_FALSE(isSaid());
}

} // namespace
} // namespace espalier
