#pragma once

#include "tests/app/window/preview_fixture.h"

#include <QString>
#include <QStringList>

namespace espalier::test {

/// The real window with a plant in it, of which pictures for the manual are taken. They are written
/// to the folder of the environment variable ESPALIER_PICTURES.
class Studio : public PreviewTest {
protected:
  void SetUp() override; // without a plant
  void TearDown() override;

  /// Runs the program, as on the command line, in the folder of the test.
  void run(const QStringList& arguments);
  /// Opens the scan of a simulated plant, NAME.ply; its truth is NAME.mtg.
  void openSimulated(const QString& name, const QStringList& options);
  void reconstruct();
  void showSide(const QString& id, int height); // the dock of this id alone at the bottom

  void press(const QPoint& place, Qt::KeyboardModifiers modifiers = Qt::NoModifier);
  void moveTo(const QPoint& place, Qt::KeyboardModifiers modifiers = Qt::NoModifier);

  /// Waits until nothing moves, and takes a picture of a widget.
  QImage taken(QWidget& widget);
  void save(const QImage& image, const QString& name);
};

/// Pictures of one size side by side, in rows of `columns`.
[[nodiscard]] QImage together(const std::vector<QImage>& images, int columns);

} // namespace espalier::test
