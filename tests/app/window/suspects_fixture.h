#pragma once

#include "app/window/review/doubts_flow.h"
#include "app/window/review/findings_flow.h"
#include "core/skeleton/edits.h"
#include "core/skeleton/select.h"
#include "tests/app/window/window_fixture.h"
#include "ui/document/plant_document.h"
#include "ui/panels/suspects_panel.h"

#include <QAction>
#include <QComboBox>
#include <QTest>

#include <algorithm>
#include <set>
#include <stdexcept>

namespace espalier::test {

/// A plant with findings of several kinds, and doubts.
class SuspectsTest : public WindowTest {
protected:
  void SetUp() override {
    WindowTest::SetUp();
    window().resize(1280, 800);
    openReconstructedSample();
    const Skeleton plant = document().skeleton();
    document().edit("Thicker", [&](SkeletonEditor& editor) {
      int left = 3;
      for (const NodeId id : plant.ids())
        if (plant[id].parent && plant.children(id).empty() && left-- > 0)
          editor.setRadius(id, 2 * plant[*plant[id].parent].radius);
    });
    key(Qt::Key_F8);
    ASSERT_TRUE(waitForAll());
    ASSERT_GE(findings().size(), 3U);
    ASSERT_GE(doubts().size(), 3U);
  }
  [[nodiscard]] bool waitForAll() {
    return QTest::qWaitFor(
        [this] {
          return window().part<FindingsFlow>().isAllChecked() &&
                 window().part<DoubtsFlow>().isKnown() && !window().part<DoubtsFlow>().isBusy();
        },
        patience);
  }
  const std::vector<Finding>& findings() { return window().part<FindingsFlow>().findings(); }
  const std::vector<Doubt>& doubts() { return window().part<DoubtsFlow>().doubts(); }
  SuspectsPanel& panel() { return find<SuspectsPanel>("findings_panel"); }
  const std::vector<Suspect>& rows() { return panel().suspects(); }
  QComboBox& kinds() { return find<QComboBox>("findings_kind"); }
  QComboBox& places() { return find<QComboBox>("findings_place"); }
  static void choose(QComboBox& box, const QString& text) {
    const int at = box.findText(text, Qt::MatchStartsWith);
    ASSERT_GE(at, 0) << text.toStdString();
    box.setCurrentIndex(at);
    emit box.activated(at);
  }
  void go(std::size_t row) {
    panel().setCurrent(row);
    emit panel().chosen(row);
  }
  std::size_t first(bool isDoubt) {
    return static_cast<std::size_t>(std::ranges::find(rows(), isDoubt, &Suspect::isDoubt) -
                                    rows().begin());
  }
  /// One of a simulated plant, whose points are then without wood.
  void removeABranch() {
    const Skeleton plant = document().skeleton();
    const auto length = [&](NodeId id) { return downstream(plant, {id}).size(); };
    const std::vector<NodeId> ids = plant.ids();
    const auto branch = std::ranges::find_if(ids, [&](NodeId id) {
      return plant[id].parent && plant[id].edge == EdgeType::branching && length(id) >= 35 &&
             length(id) <= 80;
    });
    ASSERT_NE(branch, ids.end());
    document().edit("Remove", [&](SkeletonEditor& editor) { removeSubtree(editor, *branch); });
    ASSERT_TRUE(waitForAll());
  }
  /// Of a doubt about points that a finding is about, too, once the search for both has ended.
  std::size_t rowOfATwin() {
    const auto isTwin = [](const Suspect& one) { return one.isDoubt() && one.twin.has_value(); };
    const bool isThere =
        QTest::qWaitFor([&] { return std::ranges::any_of(rows(), isTwin); }, patience);
    if (!isThere) {
      ADD_FAILURE() << "no row of both; " << kinds().currentText().toStdString() << ", "
                    << rows().size() << " rows of " << doubts().size() << " doubts and "
                    << findings().size() << " findings";
      throw std::runtime_error("no row of a doubt and a finding");
    }
    return static_cast<std::size_t>(std::ranges::find_if(rows(), isTwin) - rows().begin());
  }
  /// Each doubt is a row, and each finding but bare twigs that a doubt is about, too.
  void expectAllListed() {
    std::set<std::size_t> listed;
    std::set<std::size_t> withADoubt;
    std::size_t doubtRows = 0;
    for (const Suspect& row : rows()) {
      if (!row.isDoubt()) {
        listed.insert(row.number);
      } else {
        ++doubtRows;
        if (row.twin) withADoubt.insert(*row.twin);
      }
    }
    EXPECT_EQ(doubtRows, doubts().size());
    EXPECT_EQ(rows().size(), doubtRows + listed.size());
    for (std::size_t i = 0; i < findings().size(); ++i)
      if (!listed.contains(i)) {
        EXPECT_EQ(findings()[i].kind, Finding::Kind::unexplainedPoints) << i;
      } else {
        EXPECT_FALSE(withADoubt.contains(i)) << i;
      }
    EXPECT_GE(findings().size() - listed.size(), withADoubt.size()); // one may be about several
  }
  bool isAsked() { return action("answer_1").isEnabled(); }
  std::vector<NodeId> nodesOfRow(const Suspect& row) {
    if (!row.isDoubt()) return nodesOf(findings()[row.number]);
    const Doubt& doubt = doubts()[row.number];
    return doubt.nodes.empty() ? std::vector<NodeId>{doubt.node} : doubt.nodes;
  }
};

} // namespace espalier::test
