#include "app/window/edit/editing.h"
#include "app/window/frame/action_set.h"
#include "core/base/error.h"
#include "tests/support/plants.h"
#include "ui/view/plant_view.h"

#include <QAction>
#include <QLineEdit>
#include <QTest>
#include <QVBoxLayout>

#include <gmock/gmock.h>

namespace espalier {
namespace {

/// Shows a node that it would add to the root, and adds it when that is accepted.
class PreviewTool : public Tool {
public:
  using Tool::Tool;

  QString hint() const override { return "Enter accepts, Esc drops"; }
  bool hasPreview() const override { return isShown_; }
  void show() {
    isShown_ = true;
    canvas().showPreview({.lines = {{{0, 0, 0}, {1, 0, 0}}}, .nodes = {{1, 0, 0}}, .label = {}});
    emit hintChanged();
  }
  void accept() override {
    if (refuses) throw Error("there is no room");
    cancel();
    document().edit("Add", [](SkeletonEditor& editor) {
      editor.add({.position = {1, 0, 0}, .parent = test::forkRoot});
    });
  }
  void cancel() override {
    isShown_ = false;
    canvas().showPreview({});
  }

  bool refuses = false;

private:
  bool act(const ToolInput& /*input*/) override { return false; }
  bool isShown_ = false;
};

/// A window of a view and a field, and a tool that shows previews.
class EditingTest : public testing::Test {
protected:
  EditingTest() {
    auto* column = new QVBoxLayout(&window_);
    column->addWidget(view_ = new PlantView(&window_));
    column->addWidget(field_ = new QLineEdit(&window_));
    document_.openSkeleton(test::fork(3), "fork.mtg");
    const auto make = [this](PlantDocument& document, Canvas& canvas) {
      auto tool = std::make_unique<PreviewTool>(document, canvas);
      tool_ = tool.get();
      return tool;
    };
    editing_ = std::make_unique<Editing>(
        document_, *view_, actions_,
        std::vector<ToolEntry>{{"other",
                                "Other",
                                "Is another",
                                "select",
                                {},
                                {},
                                [](PlantDocument& document, Canvas& canvas) {
                                  return std::make_unique<PreviewTool>(document, canvas);
                                }},
                               {"preview", "Preview", "Shows", "add", {}, {}, make}});
    editing_->useTool("preview");
    window_.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&window_));
    QApplication::setActiveWindow(&window_);
    view_->setFocus();
  }

  QWidget window_;
  ActionSet actions_{window_};
  PlantDocument document_;
  PlantView* view_ = nullptr;
  QLineEdit* field_ = nullptr;
  PreviewTool* tool_ = nullptr;
  std::unique_ptr<Editing> editing_;
};

TEST_F(EditingTest, AcceptsAPreviewWithEitherEnter) {
  for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Enter}) {
    const std::size_t before = document_.skeleton().size();
    tool_->show();
    QTest::keyClick(view_, key);
    EXPECT_EQ(document_.skeleton().size(), before + 1);
    EXPECT_FALSE(tool_->hasPreview());
  }
}

TEST_F(EditingTest, DropsAPreviewAndKeepsTheTool) {
  tool_->show();
  editing_->escape();
  EXPECT_FALSE(tool_->hasPreview());
  EXPECT_EQ(editing_->currentTool(), "preview");
  EXPECT_EQ(document_.undoStack().count(), 0);
  editing_->escape();
  EXPECT_EQ(editing_->currentTool(), "other");
}

TEST_F(EditingTest, KeepsAPreviewThatIsRefused) {
  QString reason;
  QObject::connect(&actions_, &ActionSet::refused, &window_,
                   [&](const QString& text) { reason = text; });
  tool_->show();
  tool_->refuses = true;
  QTest::keyClick(view_, Qt::Key_Return);
  EXPECT_EQ(reason, "There is no room");
  EXPECT_TRUE(tool_->hasPreview());
}

TEST_F(EditingTest, DropsAPreviewWithAnotherToolAndWithUndo) {
  tool_->show();
  editing_->useTool("other");
  EXPECT_FALSE(tool_->hasPreview());
  editing_->useTool("preview");
  tool_->show();
  QTest::keyClick(view_, Qt::Key_Return);
  tool_->show();
  editing_->undo();
  EXPECT_FALSE(tool_->hasPreview());
  EXPECT_EQ(document_.undoStack().index(), 1) << "what is seen last goes first";
}

TEST_F(EditingTest, LeavesEnterToAFieldWhileThereIsNoPreview) {
  int entered = 0;
  QObject::connect(field_, &QLineEdit::returnPressed, &window_, [&] { ++entered; });
  field_->setFocus();
  QTest::keyClick(field_, Qt::Key_Return);
  EXPECT_EQ(entered, 1);
  EXPECT_FALSE(actions_["accept"]->isEnabled());
}

TEST_F(EditingTest, AcceptsNothingInAReadOnlyPlant) {
  tool_->show();
  document_.setReadOnly("it is signed");
  QTest::keyClick(view_, Qt::Key_Return);
  EXPECT_EQ(document_.undoStack().count(), 0);
}

} // namespace
} // namespace espalier
