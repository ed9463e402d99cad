#pragma once

#include "app/window/evaluate/evaluation_flow.h"
#include "core/evaluate/evaluation.h"
#include "core/io/formats.h"
#include "core/skeleton/edits.h"
#include "tests/app/window/project_fixture.h"
#include "tests/support/canonical.h"

#include <QLabel>
#include <QTest>
#include <QTreeWidget>

#include <cmath>
#include <string>

namespace espalier::test {

/// A fork of three shoots as reference, and plants that differ from it.
struct EvaluationWindowTest : ProjectWindowTest {
  /// A fork whose edges have nodes every tenth, so that a tolerance of some hundredths fits.
  static Skeleton plant() {
    Skeleton made = stick(11, 0.1);
    for (int shoot = 0; shoot < 3; ++shoot) {
      NodeId last{10};
      const double angle = 2 * M_PI * shoot / 3;
      for (int i = 1; i <= 10; ++i)
        last = made.add(
            {.position = {0.1 * i * std::cos(angle), 0.1 * i * std::sin(angle), 1 + 0.1 * i},
             .radius = 0.01,
             .parent = last,
             .edge = i == 1 && shoot > 0 ? EdgeType::branching : EdgeType::successor});
    }
    for (const NodeId id : made.ids())
      made.setRadius(id, 0.01);
    return made;
  }
  static NodeId shoot(int number) { return NodeId{static_cast<std::uint32_t>(11 + 10 * number)}; }
  QString write(const QString& name, const Skeleton& skeleton) {
    writeStructure(toPath(path(name)), skeleton);
    return path(name);
  }
  /// Opens a plant, made of the reference by an edit, and loads that reference.
  template <class Edit> void compare(const Edit& edit) {
    Skeleton result = plant();
    SkeletonEditor editor(result);
    edit(editor);
    static_cast<void>(editor.commit());
    const QString file = write("plant.mtg", result);
    open({file});
    load(write("expert.mtg", plant()));
  }
  void load(const QString& file) {
    answer(chooseFile(file), [this] { action("load_reference").trigger(); });
    waitForJob();
    EXPECT_TRUE(waitForScores());
  }
  /// None until something is compared.
  [[nodiscard]] const std::shared_ptr<const Evaluation>& evaluation() {
    return window().part<EvaluationFlow>().evaluation();
  }
  [[nodiscard]] QString score(const QString& name) { return find<QLabel>("score_" + name).text(); }
  [[nodiscard]] bool waitForScores() {
    return QTest::qWaitFor(
        [&] {
          return score("f") != QStringLiteral("–") &&
                 find<QLabel>("score_f").property("role") == "value";
        },
        patience);
  }
  [[nodiscard]] bool waitForErrors(int count) {
    const QString title = count == 1 ? "1 error" : QStringLiteral("%1 errors").arg(count);
    return QTest::qWaitFor([&] { return errors() == title; }, patience);
  }
  [[nodiscard]] QString errors() { return find<QLabel>("differences_title").text(); }
  QTreeWidget& list() { return find<QTreeWidget>("differences_list"); }
  [[nodiscard]] QString kind(int row) { return list().topLevelItem(row)->text(0); }
  [[nodiscard]] bool isPlantTheReference() {
    return canonical(withoutEntities(document().skeleton())) == canonical(plant());
  }
};

} // namespace espalier::test
