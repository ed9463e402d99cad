#pragma once

#include "app/window/main_window.h"
#include "ui/view/plant_view.h"

#include <QSettings>
#include <QTemporaryDir>
#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <optional>

class QAction;
class QDialog;

namespace espalier::test {

/// The real window, driven by the events that a hand would cause.
class WindowTest : public testing::Test {
protected:
  /// A deadline for what would else run on for ever, not a measurement [ms].
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) // several times slower
  static constexpr int patience = 300'000;
#else
  static constexpr int patience = 60'000;
#endif

  WindowTest();
  ~WindowTest() override;

  void restart(); // closes the window, as it is, and opens another with the same settings
  [[nodiscard]] QString path(const QString& name) const {
    return folder_.filePath(name);
  }
  /// A scan of a trunk with three branches, in m, at `name` in the test's folder.
  QString writeScan(const QString& name) const;
  /// The skeleton test::fork(3), saved at `name`.
  QString writeFork(const QString& name) const;

  [[nodiscard]] MainWindow& window() {
    return *window_;
  }
  [[nodiscard]] PlantDocument& document() {
    return window_->document();
  }
  [[nodiscard]] PlantView& view() {
    return window_->view();
  }
  void edit(); // of forkTop, named "Move"
  /// The node that stands at this place, whatever its id in the file.
  NodeId nodeAt(const Eigen::Vector3d& place);
  [[nodiscard]] QAction& action(const QString& id);
  template <class Widget> Widget& find(const QString& name) {
    auto* widget = window_->findChild<Widget*>(name);
    EXPECT_NE(widget, nullptr) << name.toStdString();
    return *widget;
  }

  /// And waits until it is there; a scan in place of another is a plant of its own.
  void open(const QStringList& paths);
  /// The sample with its skeleton. It is reconstructed once, and put in place as often as needed.
  void openReconstructedSample();
  void waitForJob();
  void waitForView(); // until the camera rests
  void key(int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier);
  void keyOnceDrawn(int key); // as which answers a question
  void clickButton(const QString& name);

  /// Where the pointer picks exactly this node; moves the camera to it if it is covered.
  QPoint placeOf(NodeId id);
  void hover(const QPoint& place);
  void click(const QPoint& place, Qt::KeyboardModifiers modifiers = Qt::NoModifier,
             Qt::MouseButton button = Qt::LeftButton);
  void drag(const QPoint& from, const QPoint& to);

  /// Runs `act`, which opens a dialog, and answers it.
  void answer(const std::function<void(QDialog&)>& reply, const std::function<void()>& act);
  /// Runs `act`, which opens no dialog; one that opens is closed.
  void expectNoDialog(const std::function<void()>& act);
  /// A reply that presses the button of this text.
  [[nodiscard]] static std::function<void(QDialog&)> press(const QString& button);
  /// A reply to a file dialog.
  [[nodiscard]] static std::function<void(QDialog&)> chooseFile(const QString& path);

private:
  QTemporaryDir folder_;
  std::unique_ptr<QSettings> settings_;
  std::unique_ptr<MainWindow> window_;
};

} // namespace espalier::test
