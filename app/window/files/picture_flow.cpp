#include "app/window/files/picture_flow.h"

#include "app/window/files/file_filters.h"
#include "app/window/files/load_files.h"
#include "app/window/frame/action_set.h"
#include "core/base/error.h"
#include "core/io/atomic_file.h"
#include "ui/view/picture.h"
#include "ui/view/plant_view.h"

#include <QAction>
#include <QFileDialog>
#include <QFileInfo>

#include <ostream>

namespace espalier {

PictureFlow::PictureFlow(const Parts& parts) : parts_(parts) {
  parts_.actions.beginSection(tr("File"));
  parts_.actions.add({.id = "save_picture",
                      .text = tr("Save Picture…"),
                      .help = tr("Writes what the view shows as a PNG picture, with twice as many "
                                 "pixels as on the screen in each direction"),
                      .keys = QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_P),
                      .menu = "file/export"},
                     [this] { choose(); });
}

void PictureFlow::setPlantShown(bool isShown) {
  parts_.actions["save_picture"]->setEnabled(isShown);
}

void PictureFlow::choose() {
  QFileDialog dialog(&parts_.window, tr("Save the picture"), {}, tr("PNG pictures (*.png)"));
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix("png");
  proposeBeside(dialog, parts_.document, ".png");
  if (dialog.exec() == QDialog::Accepted) write(dialog.selectedFiles().front());
}

void PictureFlow::write(const QString& path) {
  if (QFileInfo(path).suffix().toLower() != "png")
    throw Error(tr("%1: pictures are written as PNG: choose a name that ends in .png")
                    .arg(path)
                    .toStdString());
  const double pixelRatio = 2 * parts_.view.devicePixelRatio();
  const QSize size = parts_.view.size() * pixelRatio;
  const QByteArray bytes = pngOf(parts_.view.picture(size, pixelRatio));
  writeAtomically(toPath(path),
                  [&](std::ostream& out) { out.write(bytes.constData(), bytes.size()); });
  emit reported({.text = tr("Wrote %1, %2 × %3 pixels")
                             .arg(QFileInfo(path).fileName())
                             .arg(size.width())
                             .arg(size.height())});
}

} // namespace espalier
