// Work for hours: plants opened, reconstructed, edited, undone, saved, closed and opened again take
// no further memory. ESPALIER_SOAK_MINUTES=120 runs it for long and prints what it takes.
#include "app/window/frame/action_set.h"
#include "tests/app/window/project_fixture.h"

#include <QFile>
#include <QPixmapCache>
#include <QTest>
#include <QUndoStack>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iostream>
#include <malloc.h>
#include <random>
#include <unistd.h>

namespace espalier {
namespace {

double resident() { // [MB]
  std::ifstream in("/proc/self/statm");
  double all = 0;
  double inMemory = 0;
  in >> all >> inMemory;
  return inMemory * static_cast<double>(sysconf(_SC_PAGESIZE)) * 1e-6;
}

double allocated() { // [MB], of what was taken and not given back
  const struct mallinfo2 now = mallinfo2();
  return static_cast<double>(now.uordblks + now.hblkhd) * 1e-6;
}

double medianOf(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

class SoakTest : public test::ProjectWindowTest {
protected:
  void work(int round);

  static double minutes() {
    const char* text = std::getenv("ESPALIER_SOAK_MINUTES");
    return text == nullptr ? 0 : std::atof(text);
  }

private:
  void editSome();
  void lookAround();
  NodeId anyNode() {
    const std::vector<NodeId> ids = document().skeleton().ids();
    return ids[random_() % ids.size()];
  }

  std::mt19937 random_{3};
};

void SoakTest::editSome() {
  for (int i = 0; i < 40; ++i) {
    const NodeId id = anyNode();
    document().edit("Move", [&](SkeletonEditor& editor) {
      editor.setPosition(id, document().skeleton()[id].position + Eigen::Vector3d(0, 0, 1e-3));
    });
    document().selection().set({id});
    if (i % 8 == 0) action("split_edge").trigger();
    if (i % 13 == 0) action("remove_subtree").trigger();
    if (document().skeleton().size() < 5) document().undoStack().undo();
  }
  QUndoStack& steps = document().undoStack();
  const Skeleton plant = document().skeleton();
  for (int i = 0; i < 30; ++i)
    steps.undo();
  for (int i = 0; i < 30; ++i)
    steps.redo();
  EXPECT_EQ(document().skeleton(), plant);
}

void SoakTest::lookAround() {
  const QPoint middle = view().rect().center();
  drag(middle, middle + QPoint(80, 20));
  for (const char* id : {"two_views", "node_color_radius", "frame_all", "next_finding"})
    if (QAction* act = window().actionSet()[id]; act != nullptr && act->isEnabled()) act->trigger();
  QTest::qWait(50);
}

void SoakTest::work(int round) {
  open({path("scan.xyz")});
  action("reconstruct").trigger();
  waitForJob();
  ASSERT_GT(document().skeleton().size(), 10U) << message().toStdString();
  editSome();
  lookAround();
  const QString project = saveProject(QStringLiteral("round_%1.espalier").arg(round));
  const Skeleton saved = document().skeleton();
  action("close_plant").trigger();
  waitForJob();
  ASSERT_TRUE(document().isEmpty());
  open({project});
  EXPECT_EQ(document().skeleton(), saved);
  editSome();
  lookAround();
  action("close_plant").trigger();
  waitForJob();
  QFile::remove(project);
}

TEST_F(SoakTest, KeepsNoWidgetsOfPlantsThatWere) {
  const QString file = writeFork("fork.mtg");
  const auto widgetsAfter = [&](int openings) {
    for (int i = 0; i < openings; ++i) {
      open({file});
      action("close_plant").trigger();
      waitForJob();
    }
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    return window().findChildren<QWidget*>().size();
  };
  const auto first = widgetsAfter(2);
  EXPECT_LE(widgetsAfter(8), first);
}

TEST_F(SoakTest, TakesNoFurtherMemory) {
  writeScan("scan.xyz");
  const auto begin = std::chrono::steady_clock::now();
  const auto passed = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() / 60;
  };
  std::vector<double> taken;
  for (int round = 0; round < 3 || passed() < minutes(); ++round) {
    work(round);
    if (HasFatalFailure()) return;
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    QPixmapCache::clear(); // it grows up to a bound of its own
    malloc_trim(0);
    taken.push_back(allocated());
    if (minutes() > 0)
      std::cerr << passed() << " min, round " << round << ": " << taken.back() << " MB allocated, "
                << resident() << " MB resident" << std::endl;
  }
  if (taken.size() < 12) return; // too few to see what grows
  const auto third = static_cast<std::ptrdiff_t>(taken.size() / 3);
  const double before = medianOf({taken.begin() + third, taken.begin() + 2 * third});
  EXPECT_LT(medianOf({taken.end() - third, taken.end()}), 1.01 * before);
}

} // namespace
} // namespace espalier
