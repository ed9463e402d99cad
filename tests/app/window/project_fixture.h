#pragma once

#include "app/window/files/load_files.h"
#include "core/project/project.h"
#include "tests/app/window/window_fixture.h"
#include "tests/support/plants.h"
#include "ui/panels/message_banner.h"
#include "ui/panels/pipeline_panel.h"

#include <QAction>
#include <QDir>

namespace espalier::test {

/// The window with projects of the test's own.
struct ProjectWindowTest : WindowTest {
  void setRadius(double radius) {
    document().edit("Radius", [=](SkeletonEditor& editor) { editor.setRadius(forkTop, radius); });
  }
  /// Of which a node is thicker than its parent, in a file that has it so.
  QString openWithAFinding() {
    QString file = writeFork("fork.mtg");
    open({file});
    document().edit("Thicker", [](SkeletonEditor& editor) {
      editor.setRadius(editor.skeleton().children(forkTop).front(), 0.9);
    });
    key(Qt::Key_S, Qt::ControlModifier);
    return file;
  }
  QString saveProject(const QString& name) {
    const QString file = path(name);
    answer(chooseFile(file), [this] { action("save_project_as").trigger(); });
    return file;
  }
  [[nodiscard]] static History onDisk(const QString& file) {
    return Project::open(toPath(file), Access::readOnly).history().value;
  }
  [[nodiscard]] QStringList sessionFiles() const {
    return QDir(path("sessions")).entryList({"*.espalier"}, QDir::Files);
  }
  [[nodiscard]] PipelineOptions options() {
    return window().findChild<PipelinePanel*>()->options();
  }
  [[nodiscard]] QString message() { return window().banner().text(); }
};

} // namespace espalier::test
