#include "tests/pictures/studio.h"

#include <QApplication>
#include <QDir>
#include <QDockWidget>
#include <QMainWindow>
#include <QMouseEvent>
#include <QPainter>
#include <QProcess>

namespace espalier::test {

void Studio::SetUp() {
  if (qEnvironmentVariableIsEmpty("ESPALIER_PICTURES"))
    GTEST_SKIP() << "ESPALIER_PICTURES does not say where pictures are wanted";
  restart();
}

void Studio::TearDown() {
  if (action("leave").isEnabled()) action("leave").trigger();
}

void Studio::run(const QStringList& arguments) {
  QProcess program;
  program.setWorkingDirectory(path({}));
  program.start(QStringLiteral(ESPALIER_PROGRAM), arguments);
  ASSERT_TRUE(program.waitForFinished(10 * patience));
  ASSERT_EQ(program.exitCode(), 0) << program.readAllStandardError().toStdString();
}

void Studio::openSimulated(const QString& name, const QStringList& options) {
  run(QStringList{"simulate", "-o", name} + options);
  open({path(name + ".ply")});
  document().setUnit(LengthUnit::meter);
  waitForView();
}

void Studio::reconstruct() {
  action("reconstruct").trigger();
  waitForJob();
  clickButton("dismiss"); // how long it took
  waitForView();
}

void Studio::showSide(const QString& id, int height) {
  auto& dock = find<QDockWidget>(id);
  action("show_" + id).setChecked(true);
  dock.raise();
  window().resizeDocks({&dock}, {height}, Qt::Vertical);
  QTest::qWait(50);
}

void Studio::press(const QPoint& place, Qt::KeyboardModifiers modifiers) {
  hover(place);
  QTest::mousePress(&view(), Qt::LeftButton, modifiers, place);
}

void Studio::moveTo(const QPoint& place, Qt::KeyboardModifiers modifiers) {
  QMouseEvent move(QEvent::MouseMove, QPointF(place), QPointF(view().mapToGlobal(place)),
                   Qt::NoButton, Qt::LeftButton, modifiers);
  QApplication::sendEvent(&view(), &move);
}

QImage Studio::taken(QWidget& widget) {
  waitForView();
  QTest::qWait(300); // panels follow a moment later
  waitForView();
  return widget.grab().toImage().convertToFormat(QImage::Format_RGB32);
}

void Studio::save(const QImage& image, const QString& name) {
  const QImage few = image.convertToFormat(QImage::Format_Indexed8, Qt::ThresholdDither);
  ASSERT_TRUE(few.save(QDir(qEnvironmentVariable("ESPALIER_PICTURES")).filePath(name), "PNG", 0));
}

QImage together(const std::vector<QImage>& images, int columns) {
  constexpr int gap = 4;
  const QSize each = images.front().size();
  const int rows = (static_cast<int>(images.size()) + columns - 1) / columns;
  QImage all(columns * (each.width() + gap) - gap, rows * (each.height() + gap) - gap,
             QImage::Format_RGB32);
  all.fill(QColor(0xd9, 0xde, 0xdb));
  QPainter painter(&all);
  for (int i = 0; i < static_cast<int>(images.size()); ++i)
    painter.drawImage(i % columns * (each.width() + gap), i / columns * (each.height() + gap),
                      images[static_cast<std::size_t>(i)]);
  return all;
}

} // namespace espalier::test
