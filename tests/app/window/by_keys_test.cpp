// What is done by the keyboard alone: all from a scan to the certificate of a signed plant.
#include "app/window/files/load_files.h"
#include "app/window/review/doubts_flow.h"
#include "app/window/review/findings_flow.h"
#include "core/project/project.h"
#include "core/skeleton/axes.h"
#include "core/skeleton/edits.h"
#include "core/skeleton/select.h"
#include "tests/app/window/window_fixture.h"
#include "tests/support/plants.h"
#include "tests/support/shared_data.h"
#include "ui/panels/status_line.h"
#include "ui/panels/suspects_panel.h"

#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QTest>

#include <algorithm>
#include <functional>
#include <iostream>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace espalier {
namespace {

/// Mistakes of five kinds, by the node that each is at.
struct Mistakes {
  NodeId second; // of two successors
  NodeId thick;  // on a thin one
  NodeId moved;  // back behind its parent
  NodeId astray; // a branch that is attached to the root
  NodeId cutOff; // a branch that is gone, as is what it carried
};

class ByKeysTest : public test::WindowTest {
protected:
  static constexpr int mostTabs = 12; // to one field: a hand presses no more

  /// What has it; a window manager gives it to the window again once a list has closed.
  QWidget* keyboard() {
    if (QApplication::focusWidget() == nullptr) QApplication::setActiveWindow(&window());
    return QApplication::focusWidget();
  }
  /// To what has the keyboard.
  void press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QWidget* const at = keyboard();
    ASSERT_NE(at, nullptr) << "nothing has the keyboard";
    EXPECT_TRUE(at->isVisible()) << at->objectName().toStdString();
    QTest::keyClick(at, key, modifiers);
    ++pressed_;
  }
  void type(const QString& text) {
    for (const QChar sign : text) { // the keyboard may go elsewhere meanwhile
      QTest::keyClicks(keyboard(), sign);
      ++pressed_;
    }
  }
  void tabBackTo(const QString& name) {
    for (int i = 0; i < mostTabs && keyboard()->objectName() != name; ++i)
      press(Qt::Key_Tab, Qt::ShiftModifier);
    EXPECT_EQ(keyboard()->objectName(), name);
  }
  /// Runs `open`, which opens a dialog, and has `reply` close it: then the keyboard is back where
  /// it was.
  void inDialog(const std::function<void()>& open, const std::function<void()>& reply) {
    const QWidget* const before = keyboard();
    bool isAnswered = false;
    answer(
        [&](QDialog& dialog) {
          QApplication::setActiveWindow(&dialog); // as a window manager would
          const bool isIn =
              QTest::qWaitFor([&] { return dialog.isAncestorOf(keyboard()); }, patience);
          EXPECT_TRUE(isIn) << dialog.windowTitle().toStdString();
          if (isIn) reply();
          EXPECT_FALSE(dialog.isVisible()) << dialog.windowTitle().toStdString();
          if (dialog.isVisible()) dialog.reject();
          isAnswered = true;
        },
        [&] {
          open();
          EXPECT_TRUE(QTest::qWaitFor([&] { return isAnswered; }, patience));
        });
    EXPECT_EQ(keyboard(), before);
  }
  void chooseFile(const QString& file) {
    type(file);
    press(Qt::Key_Return);
  }
  void command(const QString& words) {
    press(Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
    type(words);
    press(Qt::Key_Return);
  }
  /// How many keys were pressed since the part before.
  void endPart(const std::string& name) {
    EXPECT_EQ(keyboard(), &view()) << name;
    RecordProperty(name, pressed_);
    std::cout << name << ": " << pressed_ << " keys\n";
    pressed_ = 0;
  }

  [[nodiscard]] const FindingsFlow& found() { return window().part<FindingsFlow>(); }
  SuspectsPanel& panel() { return find<SuspectsPanel>("findings_panel"); }
  [[nodiscard]] bool waitForAll() {
    return QTest::qWaitFor(
        [this] {
          const auto& doubts = window().part<DoubtsFlow>();
          return found().isAllChecked() && doubts.isKnown() && !doubts.isBusy();
        },
        patience);
  }
  [[nodiscard]] std::optional<Finding> current() {
    const auto row = panel().current();
    if (!row || panel().suspects()[*row].isDoubt()) return std::nullopt;
    return found().findings()[panel().suspects()[*row].number];
  }
  using IsSought = std::function<bool(const Finding&)>;
  static IsSought at(NodeId node) {
    return [node](const Finding& one) {
      const std::vector<NodeId> nodes = nodesOf(one);
      return std::ranges::find(nodes, node) != nodes.end();
    };
  }
  /// Of points that lie mostly along these nodes.
  IsSought ofPointsAlong(const Skeleton& plant, const std::vector<NodeId>& nodes, double near) {
    return [this, plant, nodes, near](const Finding& one) {
      const PointCloud& cloud = *document().scan()->cloud();
      const auto isNear = [&](Eigen::Index point) {
        return std::ranges::any_of(nodes, [&](NodeId id) {
          return (cloud.position(point) - plant[id].position).norm() < near;
        });
      };
      return 2 * std::ranges::count_if(one.points, isNear) > std::ssize(one.points);
    };
  }
  /// Lists one kind of findings alone, and goes by F4 to the one that is sought.
  void goTo(const QString& kind, const IsSought& isSought) {
    ASSERT_TRUE(waitForAll());
    press(Qt::Key_Escape, Qt::ShiftModifier);
    tabBackTo("findings_kind");
    auto& kinds = find<QComboBox>("findings_kind");
    press(Qt::Key_Return); // opens it: what is typed chooses in it
    type(kind.left(5));
    press(Qt::Key_Return);
    ASSERT_TRUE(kinds.currentText().startsWith(kind)) << kinds.currentText().toStdString();
    press(Qt::Key_Escape);
    ASSERT_EQ(keyboard(), &view());
    for (std::size_t i = 0; i < panel().suspects().size(); ++i) {
      press(Qt::Key_F4);
      const std::optional<Finding> finding = current();
      ASSERT_TRUE(finding);
      if (isSought(*finding)) return waitForView();
    }
    FAIL() << "no finding of this kind is sought: " << kind.toStdString();
  }
  [[nodiscard]] bool isFound(Finding::Kind kind, NodeId node) {
    EXPECT_TRUE(QTest::qWaitFor([this] { return found().isAllChecked(); }, patience));
    return std::ranges::any_of(found().findings(), [&](const Finding& one) {
      const std::vector<NodeId> nodes = nodesOf(one);
      return one.kind == kind && std::ranges::find(nodes, node) != nodes.end();
    });
  }

  /// Branches of 35 to 80 nodes, none on another, that stand nearest to what bears them.
  std::vector<NodeId> branches() {
    const Skeleton& plant = document().skeleton();
    std::vector<NodeId> found;
    for (const NodeId id : plant.ids()) {
      if (!plant[id].parent || plant[id].edge != EdgeType::branching) continue;
      const std::vector<NodeId> own = downstream(plant, {id});
      if (own.size() < 35 || own.size() > 80) continue;
      const auto isNearer = [&](NodeId other) {
        const double toParent = (plant[*plant[id].parent].position - plant[id].position).norm();
        return other != *plant[id].parent &&
               (plant[other].position - plant[id].position).norm() <= toParent &&
               std::ranges::find(own, other) == own.end();
      };
      const bool isOnOther = std::ranges::any_of(found, [&](NodeId one) {
        return plant.isAncestor(one, id) || plant.isAncestor(id, one);
      });
      const NodeId first = plant.children(*plant[id].parent).front(); // it is kept as successor
      if (!isOnOther && first != id && std::ranges::none_of(plant.ids(), isNearer))
        found.push_back(id);
    }
    return found;
  }
  /// The node so many edges on along the axis of a branch.
  NodeId along(NodeId branch, int edges) {
    const Skeleton& plant = document().skeleton();
    for (; edges > 0; --edges) {
      const auto children = plant.children(branch);
      const auto next = std::ranges::find_if(
          children, [&](NodeId id) { return plant[id].edge == EdgeType::successor; });
      if (next == children.end()) return branch;
      branch = *next;
    }
    return branch;
  }

  void plant(const Mistakes& at) {
    const Skeleton right = document().skeleton();
    document().edit("Mistakes", [&](SkeletonEditor& editor) {
      editor.setEdge(at.second, EdgeType::successor);
      editor.setRadius(at.thick, 1.3 * right[*right[at.thick].parent].radius);
      const Eigen::Vector3d& before = right[*right[at.moved].parent].position;
      editor.setPosition(at.moved, before + 1.5 * (before - right[at.moved].position));
      reparentNode(editor, at.astray, right.roots().front());
      removeSubtree(editor, at.cutOff);
    });
  }
  /// How far the farthest of these nodes is from what the plant has now.
  double farthest(const Skeleton& from, const std::vector<NodeId>& nodes) {
    const Skeleton& now = document().skeleton();
    double most = 0;
    for (const NodeId id : nodes) {
      double least = std::numeric_limits<double>::max();
      for (const NodeId other : now.ids())
        least = std::min(least, (now[other].position - from[id].position).norm());
      most = std::max(most, least);
    }
    return most;
  }
  std::ptrdiff_t toReview() {
    const Skeleton& now = document().skeleton();
    return std::ranges::count_if(
        now.ids(), [&](NodeId id) { return now[id].review.state != ReviewState::reviewed; });
  }

  int pressed_ = 0;
};

TEST_F(ByKeysTest, LeadFromAScanToTheCertificate) {
  const QString scan =
      QString::fromStdString((test::sourceFolder() / "resources/samples/young_tree.ply").string());
  inDialog([&] { press(Qt::Key_O, Qt::ControlModifier); }, [&] { chooseFile(scan); });
  waitForJob();
  waitForView();
  ASSERT_NE(document().scan(), nullptr);
  endPart("open");

  press(Qt::Key_R, Qt::ControlModifier);
  waitForJob();
  waitForView();
  ASSERT_GT(document().skeleton().size(), 1000U);
  endPart("reconstruct");

  const QString project = path("tree.espalier");
  inDialog([&] { press(Qt::Key_S, Qt::ControlModifier | Qt::AltModifier); },
           [&] { chooseFile(project); });
  waitForJob();
  EXPECT_TRUE(QFile::exists(project));
  endPart("save");

  const Skeleton right = document().skeleton();
  const std::vector<NodeId> borne = branches();
  ASSERT_GE(borne.size(), 5U);
  const auto tips = [&](NodeId branch) {
    return std::ranges::count_if(downstream(right, {branch}),
                                 [&](NodeId id) { return right.children(id).empty(); });
  };
  const Mistakes made{.second = borne[0],
                      .thick = along(borne[1], 3),
                      .moved = along(borne[2], 4),
                      .astray = borne[3],
                      .cutOff =
                          *std::ranges::min_element(borne.begin() + 4, borne.end(), {}, tips)};
  plant(made);

  press(Qt::Key_F8);
  goTo("Two successors", at(made.second));
  press(Qt::Key_M, Qt::ShiftModifier);
  EXPECT_EQ(document().skeleton()[made.second].edge, EdgeType::branching);
  EXPECT_FALSE(isFound(Finding::Kind::twoSuccessors, made.second));
  endPart("two successors");

  goTo("Thick on thin", at(made.thick));
  for (int i = 0; i < 10 && isFound(Finding::Kind::radiusAboveParent, made.thick); ++i)
    press(Qt::Key_Q);
  EXPECT_FALSE(isFound(Finding::Kind::radiusAboveParent, made.thick));
  endPart("thick on thin");

  goTo("Sharp turns", at(made.moved));
  press(Qt::Key_Delete);
  EXPECT_FALSE(document().skeleton().contains(made.moved));
  EXPECT_FALSE(isFound(Finding::Kind::sharpTurn, *right[made.moved].parent));
  endPart("sharp turn");

  goTo("Edges off the scan", at(made.astray));
  press(Qt::Key_P);
  press(Qt::Key_Return); // the nearest wood
  EXPECT_EQ(document().skeleton()[made.astray].parent, right[made.astray].parent);
  EXPECT_EQ(document().skeleton()[made.astray].edge, EdgeType::branching);
  endPart("edges off the scan");

  std::vector<NodeId> lost = {made.cutOff}; // its axis: what few points show is no finding
  while (const auto next = nextOnAxis(right, lost.back()))
    lost.push_back(*next);
  const double spacing = document().scan()->spacing();
  ASSERT_GT(farthest(right, lost), 20 * spacing);
  goTo("Bare twigs", ofPointsAlong(right, downstream(right, {made.cutOff}), 10 * spacing));
  press(Qt::Key_B, Qt::ControlModifier);
  waitForJob();
  waitForView();
  press(Qt::Key_Return);
  EXPECT_LT(farthest(right, lost), 4 * spacing);
  EXPECT_EQ(document().skeleton().roots().size(), 1U);
  endPart("bare twig");

  press(Qt::Key_F9);
  press(Qt::Key_Return);
  ASSERT_TRUE(QTest::qWaitFor([&] { return find<QLabel>("review_place").text().contains(" left"); },
                              patience))
      << find<QLabel>("review_place").text().toStdString();
  for (int stop = 0; stop < 5; ++stop) {
    waitForView();
    const auto before = toReview();
    press(Qt::Key_Return);
    EXPECT_LT(toReview(), before) << find<QLabel>("review_place").text().toStdString();
  }
  press(Qt::Key_A, Qt::ControlModifier); // the other stops would take minutes
  command("mark all selected");
  EXPECT_TRUE(QTest::qWaitFor([&] { return toReview() == 0; }, patience));
  endPart("review");

  inDialog([&] { command("sign structure"); },
           [&] {
             EXPECT_EQ(keyboard()->objectName(), "reason");
             type("All was looked at");
             press(Qt::Key_Tab);
             EXPECT_EQ(keyboard()->objectName(), "signer");
             type("Anna");
             press(Qt::Key_Return);
           });
  EXPECT_TRUE(find<QLabel>("seal").text().startsWith("✓ Signed by Anna on "))
      << find<QLabel>("seal").text().toStdString();
  endPart("sign");

  const QString certificate = path("tree.pdf");
  inDialog([&] { command("export certificate"); }, [&] { chooseFile(certificate); });
  QFile file(certificate);
  ASSERT_TRUE(QTest::qWaitFor([&] { return file.exists(); }, patience));
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  EXPECT_EQ(file.read(4), "%PDF");
  EXPECT_TRUE(QTest::qWaitFor(
      [&] {
        return Project::open(toPath(project), Access::readOnly).document("seal").find("Anna") !=
               std::string::npos;
      },
      patience));
  endPart("certificate");
}

TEST_F(ByKeysTest, OneKeyLeadsFromThePlantToTheListOfFindings) {
  open({writeFork("fork.mtg")});
  document().edit("Two successors", [](SkeletonEditor& editor) {
    for (const NodeId id : editor.skeleton().children(test::forkTop))
      editor.setEdge(id, EdgeType::successor);
  });
  press(Qt::Key_F8);
  ASSERT_TRUE(QTest::qWaitFor([this] { return found().isAllChecked(); }, patience));
  ASSERT_FALSE(panel().suspects().empty());
  ASSERT_EQ(keyboard(), &view());
  pressed_ = 0;
  press(Qt::Key_Escape, Qt::ShiftModifier);
  EXPECT_EQ(keyboard()->objectName(), "findings_list");
  EXPECT_EQ(pressed_, 1);
  press(Qt::Key_Return); // goes to the finding
  press(Qt::Key_Escape);
  EXPECT_EQ(keyboard(), &view());
}

TEST_F(ByKeysTest, TheKeyForPanelsGoesThroughThoseInFront) {
  open({writeFork("fork.mtg")});
  press(Qt::Key_F8);
  press(Qt::Key_F11); // the table of nodes, below the plant
  const auto panelAt = [this] {
    press(Qt::Key_Escape, Qt::ShiftModifier);
    QWidget* at = keyboard();
    while (at != nullptr && qobject_cast<QDockWidget*>(at) == nullptr)
      at = at->parentWidget();
    return at == nullptr ? QString() : at->objectName();
  };
  EXPECT_EQ(panelAt(), "node_table") << "the one shown last";
  EXPECT_EQ(panelAt(), "findings") << "the inspector lies behind it";
  EXPECT_EQ(panelAt(), "pipeline");
  EXPECT_NE(qobject_cast<QComboBox*>(keyboard()), nullptr) << "the unit is its topmost field";
  const auto hint = [this] { return window().statusLine().shownText(); };
  EXPECT_TRUE(hint().contains("Esc back to the plant   Shift+Esc next panel"))
      << hint().toStdString();
  press(Qt::Key_Tab);
  const QWidget* const field = keyboard();
  press(Qt::Key_Escape);
  EXPECT_FALSE(hint().contains("back to the plant")) << hint().toStdString();
  EXPECT_EQ(panelAt(), "pipeline") << "the one that had the keyboard last";
  EXPECT_EQ(keyboard(), field) << "where it was";
  EXPECT_EQ(panelAt(), "node_table");
}

// One that lies over it, one that goes.
TEST_F(ByKeysTest, APanelThatGoesGivesTheKeyboardToThePlant) {
  open({writeFork("fork.mtg")});
  press(Qt::Key_F8);
  press(Qt::Key_Escape, Qt::ShiftModifier);
  ASSERT_NE(QApplication::focusWidget(), &view());
  press(Qt::Key_F9);
  QApplication::processEvents();
  EXPECT_EQ(QApplication::focusWidget(), &view());
  press(Qt::Key_Escape, Qt::ShiftModifier);
  ASSERT_TRUE(find<QWidget>("review_page").isAncestorOf(QApplication::focusWidget()));
  press(Qt::Key_F9);
  EXPECT_EQ(QApplication::focusWidget(), &view());
}

TEST_F(ByKeysTest, ABranchIsAttachedToTheNodeThatArrowKeysLeadTo) {
  open({writeFork("fork.mtg")});
  const NodeId branch = document().skeleton().children(test::forkTop).back();
  document().selection().set({branch});
  press(Qt::Key_P);
  press(Qt::Key_Down); // what bears it
  press(Qt::Key_Down); // and what bears that
  const NodeId root = document().skeleton().roots().front();
  ASSERT_EQ(document().selection().nodes(), std::vector{root});
  EXPECT_EQ(document().skeleton()[branch].parent, test::forkTop) << "before Enter";
  press(Qt::Key_Return);
  EXPECT_EQ(document().skeleton()[branch].parent, root);
  EXPECT_EQ(document().selection().nodes(), std::vector{branch});
}

// Enter means something else in most fields.
TEST_F(ByKeysTest, EscapeGivesTheKeyboardBackToTheView) {
  open({writeFork("fork.mtg")});
  press(Qt::Key_F8);
  press(Qt::Key_Tab, Qt::ShiftModifier);
  ASSERT_NE(keyboard(), &view());
  press(Qt::Key_Escape);
  EXPECT_EQ(keyboard(), &view());
}

} // namespace
} // namespace espalier
