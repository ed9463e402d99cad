// Pictures of the window for the manual, each of what the text beside it says.
#include "core/skeleton/edits.h"
#include "tests/pictures/studio.h"
#include "tests/support/shared_data.h"
#include "ui/document/doubt_text.h"
#include "ui/panels/cross_section_panel.h"
#include "ui/panels/judge_table.h"
#include "ui/panels/sweep_strip.h"

#include <QComboBox>
#include <QDialog>
#include <QDir>
#include <QDockWidget>
#include <QLabel>
#include <QProcess>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <QTableWidget>
#include <QTreeWidget>

#include <fstream>
#include <sstream>
#include <tuple>

namespace espalier {
namespace {

using test::together;

const QStringList pine = {"--architecture", "conifer", "--segments", "300",
                          "--points",       "60000",   "--seed",     "5"};

class ManualPictures : public test::Studio {
protected:
  QDockWidget& dock(const QString& id) { return find<QDockWidget>(id); }

  /// The skeleton of a simulated tree of few branches, seen from the front.
  void openTree() {
    openSimulated("tree", {"--segments", "40", "--points", "40000", "--seed", "2"});
    reconstruct();
    action("view_front").trigger();
    waitForView();
  }
  /// An apex whose axis is longest, but for the trunk.
  NodeId longTwig() {
    const Skeleton& plant = document().skeleton();
    NodeId best{};
    std::size_t most = 0;
    for (const NodeId id : plant.ids()) {
      if (!plant.children(id).empty()) continue;
      std::size_t nodes = 0;
      NodeId at = id;
      while (plant[at].parent && plant[at].edge == EdgeType::successor && ++nodes < 1000)
        at = *plant[at].parent;
      if (plant[at].parent && nodes > most) std::tie(most, best) = std::pair(nodes, id);
    }
    return best;
  }
  NodeId footOf(NodeId id) {
    const Skeleton& plant = document().skeleton();
    while (plant[id].edge == EdgeType::successor && plant[id].parent)
      id = *plant[id].parent;
    return id;
  }
  QPoint at(NodeId id) {
    return view().project(document().skeleton()[id].position).value_or(QPointF()).toPoint();
  }
  /// A part of the view about a place.
  QImage around(const QPoint& place, const QSize& size) {
    const QImage all = taken(view());
    QRect part({}, size);
    part.moveCenter(place);
    part.moveLeft(std::clamp(part.left(), 0, all.width() - size.width()));
    part.moveTop(std::clamp(part.top(), 0, all.height() - size.height()));
    return all.copy(part);
  }
  void look(NodeId id) {
    document().selection().set({id});
    action("frame").trigger();
    waitForView();
  }
};

TEST_F(ManualPictures, Editor) {
  open({QString::fromStdString(
      (test::sourceFolder() / "resources/samples/young_tree.ply").string())});
  reconstruct();
  save(taken(window()), "editor.png");
}

TEST_F(ManualPictures, FirstPlant) {
  action("sample_plant").trigger();
  ASSERT_TRUE(QTest::qWaitFor(
      [this] { return document().scan() != nullptr && !window().jobs().isBusy(); }, patience));
  reconstruct();
  save(taken(window()), "first-skeleton.png");
  action("ask_doubts").trigger();
  ASSERT_TRUE(QTest::qWaitFor([this] { return action("answer_1").isEnabled(); }, patience));
  save(taken(window()), "asking.png");
}

/// A question of each kind: what matters most of it.
TEST_F(ManualPictures, Doubts) {
  openSimulated("tree", {"--segments", "60", "--points", "15000", "--seed", "2"});
  reconstruct();
  const NodeId foot = footOf(longTwig()); // of a branch that is missing then
  document().edit("Remove", [&](SkeletonEditor& editor) { removeSubtree(editor, foot); });
  action("minimap").setChecked(false);
  action("show_findings").setChecked(true);
  auto& kinds = find<QComboBox>("findings_kind");
  std::vector<QImage> pictures;
  for (const Doubt::Kind kind : {Doubt::Kind::end, Doubt::Kind::attachment, Doubt::Kind::missing}) {
    int at = -1;
    ASSERT_TRUE(QTest::qWaitFor(
        [&] { return (at = kinds.findText(nameOfOne(kind), Qt::MatchStartsWith)) >= 0; }, patience))
        << nameOfOne(kind).toStdString();
    emit kinds.activated(at);
    action("ask_doubts").trigger();
    ASSERT_TRUE(QTest::qWaitFor([this] { return action("answer_1").isEnabled(); }, patience));
    waitForView();
    pictures.push_back(around(view().rect().center(), {400, 400}));
    action("stop_asking").trigger();
  }
  save(together(pictures, 3), "doubts.png");
}

TEST_F(ManualPictures, Import) {
  run({"simulate", "-o", "oak", "--points", "15000", "--segments", "100"});
  run({"convert", "oak.ply", "oak.xyz"});
  std::ifstream points(path("oak.xyz").toStdString());
  std::ofstream text(path("oak.txt").toStdString());
  text << "height north east leaf\n";
  for (std::string line; std::getline(points, line);) {
    std::istringstream fields(line);
    double x = 0;
    double y = 0;
    double z = 0;
    if (fields >> x >> y >> z) text << z << ' ' << y << ' ' << x << " 0\n";
  }
  text.close();
  answer(
      [this](QDialog& dialog) {
        dialog.resize(760, 640);
        QTest::qWait(300);
        save(dialog.grab().toImage(), "import.png");
        dialog.reject();
      },
      [this] {
        window().open({path("oak.txt")});
        waitForJob();
      });
}

TEST_F(ManualPictures, Organs) {
  openSimulated("maize", {"--architecture", "herb", "--segments", "1", "--foliage", "1",
                          "--foliage-length", "0.5", "--foliage-width", "0.05", "--foliage-gap",
                          "0.1", "--foliage-reach", "10", "--droop", "90", "--points", "60000"});
  action("view_front").trigger();
  action("color_organ").trigger();
  QTest::qWait(500);
  ASSERT_TRUE(QTest::qWaitFor([this] { return !find<QPushButton>("cancel_job").isVisible(); },
                              5 * patience));
  save(taken(window()), "organs.png");
}

TEST_F(ManualPictures, Plot) {
  openSimulated("orchard", {"--plants", "4", "--points", "100000", "--segments", "100"});
  action("view_isometric").trigger();
  action("show_plot").setChecked(true);
  clickButton("plot_find");
  ASSERT_TRUE(
      QTest::qWaitFor([this] { return !find<QPushButton>("plot_cancel").isVisible(); }, patience));
  find<QTableWidget>("plot_plants").setCurrentCell(2, 1);
  save(taken(window()), "plot.png");
}

TEST_F(ManualPictures, Register) {
  run({"simulate", "-o", "tree", "--stations", "2", "--apart", "0.05,3", "--points", "60000",
       "--segments", "100"});
  open({path("tree_1.ply")});
  document().setUnit(LengthUnit::meter);
  answer(chooseFile(path("tree_2.ply")), [this] { action("register_scan").trigger(); });
  waitForJob();
  waitForView();
  save(taken(window()), "register.png");
}

TEST_F(ManualPictures, Preview) {
  openSimulated("pine", pine);
  reconstruct();
  action("view_front").trigger();
  showSide("judge", 260);
  turnOn();
  action("keep_as_a").trigger();
  type("contract", "radius", 2.5 * number("contract", "radius").value());
  waitForPreview();
  action("compare_divided").trigger();
  auto& table = find<JudgeTable>("judge_table");
  ASSERT_TRUE(QTest::qWaitFor([&] { return table.columnCount() > 2; }, patience));
  QTest::qWait(2000);
  save(taken(window()), "preview.png");
}

TEST_F(ManualPictures, Blend) {
  openSimulated("pine", pine);
  reconstruct();
  action("view_front").trigger();
  document().selection().set({longTwig(), footOf(longTwig())});
  action("frame").trigger();
  waitForView();
  document().selection().clear();
  action("blend_points").setChecked(true);
  auto& slider = find<QSlider>("blend_slider");
  slider.setValue((slider.minimum() + slider.maximum()) / 2);
  PreviewTest::press("blend_ways");
  const QImage all = taken(window());
  const QRect bar(find<QWidget>("blend_bar").mapTo(&window(), QPoint()),
                  find<QWidget>("blend_bar").size());
  save(all.copy(bar.adjusted(0, -440, 0, 0)), "blend.png");
}

TEST_F(ManualPictures, Curve) {
  openSimulated("pine", pine);
  auto& form = step("contract");
  auto* method = form.findChild<QComboBox*>();
  method->setCurrentIndex(method->findData("adaptive_geodesic"));
  emit method->activated(method->currentIndex());
  QTest::qWait(1000);
  save(taken(form).copy(0, 0, form.width(), 440), "curve.png");
}

TEST_F(ManualPictures, Sweep) {
  openSimulated("pine", pine);
  action("view_front").trigger();
  showSide("sweep", 320);
  find<QSpinBox>("sweep_count").setValue(5);
  clickButton("sweep_run");
  auto& strip = find<SweepStrip>("sweep_strip");
  ASSERT_TRUE(QTest::qWaitFor(
      [&] {
        return std::ranges::none_of(strip.cards(),
                                    [](const SweepCard* card) { return card->item().isPending; });
      },
      patience));
  save(taken(dock("sweep")), "sweep.png");
}

TEST_F(ManualPictures, Traits) {
  openTree();
  showSide("evaluation", 230);
  QTest::qWait(2000);
  save(taken(dock("evaluation")), "traits.png");
}

TEST_F(ManualPictures, Evaluation) {
  openSimulated("pine", pine);
  reconstruct();
  answer(chooseFile(path("pine.mtg")), [this] { action("load_reference").trigger(); });
  waitForJob();
  showSide("evaluation", 240);
  QTest::qWait(3000);
  action("next_error").trigger();
  save(taken(window()), "evaluation.png");
}

TEST_F(ManualPictures, Section) {
  openTree();
  const Skeleton& plant = document().skeleton();
  NodeId node = plant.ids().front();
  for (int i = 0; i < 6; ++i)
    node = plant.children(node).front();
  const double radius = plant[node].radius;
  document().edit("Move", [&](SkeletonEditor& editor) {
    editor.setPosition(node, plant[node].position + Eigen::Vector3d(0.4 * radius, 0, 0));
  });
  look(node);
  QTest::qWait(500);
  auto* section = window().findChild<CrossSectionPanel*>();
  ASSERT_NE(section, nullptr);
  save(taken(*section), "section.png");
}

TEST_F(ManualPictures, Trace) {
  openTree();
  const NodeId apex = longTwig();
  const NodeId foot = footOf(apex);
  const NodeId bearer = *document().skeleton()[foot].parent;
  const Eigen::Vector3d end = document().skeleton()[apex].position;
  action("minimap").setChecked(false);
  document().selection().set({apex, foot});
  action("frame").trigger();
  waitForView();
  document().selection().clear();
  document().edit("Remove", [&](SkeletonEditor& editor) { removeSubtree(editor, foot); });
  action("tool_trace").trigger();
  click(at(bearer));
  const QPoint to = view().project(end).value_or(QPointF(400, 200)).toPoint();
  hover(to);
  click(to);
  EXPECT_TRUE(QTest::qWaitFor([this] { return action("accept").isEnabled(); }, patience));
  save(around((at(bearer) + to) / 2, {470, 410}), "trace.png");
}

/// One tool at work in each: how a gesture looks before the button is released.
TEST_F(ManualPictures, Tools) {
  openTree();
  action("minimap").setChecked(false);
  const NodeId apex = longTwig();
  const NodeId foot = footOf(apex);
  const NodeId bearer = *document().skeleton()[foot].parent;
  document().selection().set({apex, foot});
  action("frame").trigger();
  waitForView();
  document().selection().clear();
  const QSize size(300, 200);
  std::vector<QImage> gestures;
  const auto gesture = [&](const QString& tool, const QPoint& from, const QPoint& to,
                           Qt::KeyboardModifiers modifiers) {
    action(tool).trigger();
    press(from, modifiers);
    for (int i = 1; i <= 8; ++i)
      moveTo(from + (to - from) * i / 8 + QPoint(0, (i % 8) * (8 - i)), modifiers);
    gestures.push_back(around((from + to) / 2, size));
    action("leave").trigger();
    QTest::mouseRelease(&view(), Qt::LeftButton, modifiers, to);
    while (document().undoStack().canUndo() && document().undoStack().undoText() != "Reconstruct" &&
           document().undoStack().index() > 1)
      document().undoStack().undo();
  };
  const QPoint middle = (at(foot) + at(apex)) / 2;
  gesture("tool_add", at(apex), at(apex) + QPoint(60, -20), Qt::NoModifier);
  gesture("tool_reparent", at(foot), at(bearer) + QPoint(0, 60), Qt::NoModifier);
  gesture("tool_stroke", middle + QPoint(-50, -40), middle + QPoint(50, 40), Qt::NoModifier);
  gesture("tool_points", middle + QPoint(-50, -30), middle + QPoint(50, 10), Qt::NoModifier);
  gesture("tool_move", middle + QPoint(-60, -40), middle + QPoint(60, 40), Qt::ShiftModifier);
  action("tool_measure").trigger();
  click(at(foot));
  click(at(apex));
  gestures.push_back(around(middle, size));
  save(together(gestures, 3), "tools.png");
}

TEST_F(ManualPictures, Report) {
  run({"simulate", "-o", "pine", "--architecture", "conifer", "--segments", "150", "--points",
       "40000"});
  run({"reconstruct", "pine.ply", "-o", "found.mtg"});
  run({"evaluate", "found.mtg", "pine.mtg", "--scan", "pine.ply", "--unit", "m", "--report",
       "report.pdf"});
  QProcess pages;
  pages.setWorkingDirectory(path({}));
  pages.start("pdftoppm", {"-r", "60", "-png", "-l", "3", "report.pdf", "page"});
  ASSERT_TRUE(pages.waitForFinished(patience) && pages.exitCode() == 0)
      << "pdftoppm (poppler-utils) is needed to show pages of a PDF";
  std::vector<QImage> images;
  for (const QString& file : QDir(path({})).entryList({"page*.png"}, QDir::Files, QDir::Name))
    images.emplace_back(path(file));
  ASSERT_FALSE(images.empty());
  save(together(images, 3), "report.png");
}

} // namespace
} // namespace espalier
