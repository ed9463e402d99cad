#include "tests/app/window/window_fixture.h"

#include "app/window/files/load_files.h"
#include "app/window/frame/action_set.h"
#include "core/base/random.h"
#include "core/io/formats.h"
#include "tests/support/plants.h"
#include "tests/support/shared_data.h"

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QFileDialog>
#include <QMouseEvent>
#include <QPushButton>
#include <QTest>
#include <QTimer>

#include <fstream>
#include <numbers>
#include <utility>

namespace espalier::test {
namespace {

/// Points on a cylinder, 2000 per meter.
void addCylinder(std::ostream& out, Random& random, const Eigen::Vector3d& from,
                 const Eigen::Vector3d& to, double radius) {
  const Eigen::Vector3d axis = (to - from).normalized();
  const Eigen::Vector3d side = axis.unitOrthogonal();
  const int count = static_cast<int>(2000 * (to - from).norm());
  for (int i = 0; i < count; ++i) {
    const Eigen::AngleAxisd turn(random.uniform(0, 2 * std::numbers::pi), axis);
    const Eigen::Vector3d point = from + random.uniform() * (to - from) + radius * (turn * side);
    out << point.x() << ' ' << point.y() << ' ' << point.z() << '\n';
  }
}

} // namespace

WindowTest::WindowTest()
    : settings_(
          std::make_unique<QSettings>(folder_.filePath("settings.ini"), QSettings::IniFormat)) {
  settings_->setValue("sessions_folder", path("sessions"));
  settings_->setValue("sample_folder", path("samples"));
  settings_->setValue("pictures_folder", path("pictures"));
  settings_->setValue("tour/was_shown", true);
  restart();
}

WindowTest::~WindowTest() = default;

void WindowTest::restart() {
  window_.reset();
  // As the program starts: a sheet would be matched with each part again wherever that is put.
  static_cast<QApplication*>(QCoreApplication::instance())->setStyleSheet({});
  window_ = std::make_unique<MainWindow>(*settings_);
  window_->resize(1280, 800);
  window_->show();
  EXPECT_TRUE(QTest::qWaitForWindowExposed(window_.get()));
  QApplication::setActiveWindow(window_.get()); // a server without window manager activates none
}

void WindowTest::edit() {
  document().edit("Move", [](SkeletonEditor& editor) {
    editor.setPosition(forkTop, {0.5, 0.5, 0.5});
  });
}

NodeId WindowTest::nodeAt(const Eigen::Vector3d& place) {
  for (const NodeId id : document().skeleton().ids())
    if ((document().skeleton()[id].position - place).norm() < 1e-3) return id;
  ADD_FAILURE() << "no node there";
  return NodeId{0};
}

QString WindowTest::writeScan(const QString& name) const {
  const QString file = path(name);
  std::ofstream out(file.toStdString());
  Random random(11);
  addCylinder(out, random, {0, 0, 0}, {0, 0, 2}, 0.05);
  addCylinder(out, random, {0, 0, 1}, {0.8, 0, 1.6}, 0.02);
  addCylinder(out, random, {0, 0, 1.2}, {-0.7, 0.1, 1.9}, 0.02);
  addCylinder(out, random, {0, 0, 0.8}, {0.1, 0.7, 1.3}, 0.02);
  return file;
}

QString WindowTest::writeFork(const QString& name) const {
  writeStructure(toPath(path(name)), fork(3));
  return path(name);
}

QAction& WindowTest::action(const QString& id) {
  return *window_->actionSet()[id];
}

void WindowTest::open(const QStringList& paths) {
  QTimer alone; // where it is asked about another scan, or whether two are of the same plant
  QObject::connect(&alone, &QTimer::timeout, [] {
    auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
    if (dialog == nullptr) return;
    if (dialog->windowTitle() == "Another scan") press("Open")(*dialog);
    if (dialog->windowTitle() == "Two scans") press("Open Alone")(*dialog);
  });
  alone.start(0);
  window_->open(paths);
  alone.stop();
  if (window_->isVisible()) QApplication::setActiveWindow(window_.get()); // as in answer()
  waitForJob();
  if (view().isVisible()) waitForView();
}

void WindowTest::openReconstructedSample() {
  open({QString::fromStdString((sourceFolder() / "resources/samples/young_tree.ply").string())});
  static std::optional<std::pair<Skeleton, std::shared_ptr<const Eigen::Matrix3Xf>>> made;
  if (made) {
    document().reconstruct("Reconstruct", made->first, made->second);
  } else {
    action("reconstruct").trigger();
    waitForJob();
    ASSERT_FALSE(document().skeleton().isEmpty());
    made.emplace(document().skeleton(), document().contracted());
  }
}

void WindowTest::waitForJob() {
  ASSERT_TRUE(QTest::qWaitFor([this] { return !window_->jobs().isBusy(); }, patience));
}

void WindowTest::waitForView() {
  ASSERT_TRUE(QTest::qWaitFor([this] { return view().isStill(); }, patience));
}

void WindowTest::key(int key, Qt::KeyboardModifiers modifiers) {
  QTest::keyClick(window_.get(), static_cast<Qt::Key>(key), modifiers);
}

void WindowTest::keyOnceDrawn(int key) {
  const int frames = view().framesAtRest();
  ASSERT_TRUE(QTest::qWaitFor([&] { return view().framesAtRest() != frames || view().isStill(); },
                              patience));
  this->key(key);
}

void WindowTest::clickButton(const QString& name) {
  QTest::mouseClick(&find<QPushButton>(name), Qt::LeftButton);
}

QPoint WindowTest::placeOf(NodeId id) {
  const auto place = view().project(document().skeleton()[id].position);
  if (!place || view().pick(place->toPoint()).node != id)
    ADD_FAILURE() << "node " << indexOf(id) << " is covered";
  return place.value_or(QPointF()).toPoint();
}

// Sent at once: QTest would move the real pointer, which an X server reports when it likes.
void WindowTest::hover(const QPoint& place) {
  QMouseEvent move(QEvent::MouseMove, QPointF(place), QPointF(view().mapToGlobal(place)),
                   Qt::NoButton, Qt::NoButton, Qt::NoModifier);
  QApplication::sendEvent(&view(), &move);
}

void WindowTest::click(const QPoint& place, Qt::KeyboardModifiers modifiers,
                       Qt::MouseButton button) {
  hover(place);
  QTest::mousePress(&view(), button, modifiers, place);
  QTest::mouseRelease(&view(), button, modifiers, place);
}

void WindowTest::drag(const QPoint& from, const QPoint& to) {
  hover(from);
  QTest::mousePress(&view(), Qt::LeftButton, Qt::NoModifier, from);
  for (int step = 1; step <= 5; ++step)
    QTest::mouseMove(&view(), from + (to - from) * step / 5);
  QTest::mouseRelease(&view(), Qt::LeftButton, Qt::NoModifier, to);
}

void WindowTest::answer(const std::function<void(QDialog&)>& reply,
                        const std::function<void()>& act) {
  bool isAnswered = false;
  QTimer timer;
  QObject::connect(&timer, &QTimer::timeout, [&] {
    auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
    if (dialog == nullptr) return;
    timer.stop();
    isAnswered = true;
    reply(*dialog);
  });
  timer.start(0);
  act();
  EXPECT_TRUE(isAnswered) << "no dialog was shown";
  if (window_->isVisible()) QApplication::setActiveWindow(window_.get()); // as above
}

void WindowTest::expectNoDialog(const std::function<void()>& act) {
  QTimer timer;
  QObject::connect(&timer, &QTimer::timeout, [] {
    auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
    if (dialog == nullptr) return;
    ADD_FAILURE() << dialog->windowTitle().toStdString();
    dialog->reject();
  });
  timer.start(0);
  act();
}

std::function<void(QDialog&)> WindowTest::press(const QString& text) {
  return [text](QDialog& dialog) {
    for (QPushButton* button : dialog.findChildren<QPushButton*>())
      if (button->text().remove('&') == text) {
        QTest::mouseClick(button, Qt::LeftButton);
        return;
      }
    ADD_FAILURE() << "no button " << text.toStdString();
    dialog.reject();
  };
}

std::function<void(QDialog&)> WindowTest::chooseFile(const QString& path) {
  return [path](QDialog& dialog) {
    auto* files = qobject_cast<QFileDialog*>(&dialog);
    ASSERT_NE(files, nullptr);
    files->setDirectory(QFileInfo(path).path());
    files->selectFile(path);
    QMetaObject::invokeMethod(files, "accept");
  };
}

} // namespace espalier::test
