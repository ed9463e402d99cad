// What is asked of a scan before it is read.
#include "app/window/files/file_flow.h"
#include "app/window/frame/action_set.h"
#include "core/io/glance.h"
#include "ui/dialogs/scan_dialog.h"
#include "ui/document/shown_message.h"
#include "ui/jobs/job_slot.h"

#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

#include <limits>
#include <utility>

namespace espalier {

FileFlow::Second FileFlow::askAbout(const QString& another) const {
  const QString name = QFileInfo(another).fileName();
  const QString open = QFileInfo(parts_.document.scanPath()).fileName();
  QMessageBox box(QMessageBox::NoIcon, tr("Another scan"),
                  tr("<b>Open %1 in place of %2?</b>").arg(name, open), QMessageBox::NoButton,
                  &parts_.window);
  box.setInformativeText(
      tr("If both are scans of the same plant, register %1: it is laid on %2, and "
         "the two can be joined.")
          .arg(name, open));
  const QPushButton* registers = box.addButton(tr("Register"), QMessageBox::ActionRole);
  QPushButton* opens = box.addButton(tr("Open"), QMessageBox::AcceptRole);
  box.setEscapeButton(box.addButton(tr("Cancel"), QMessageBox::RejectRole));
  box.setDefaultButton(opens);
  box.exec();
  if (box.clickedButton() == registers) return Second::registered;
  return box.clickedButton() == opens ? Second::opened : Second::left;
}

FileFlow::Second FileFlow::askAboutTwo(const QString& first, const QString& second) const {
  const QString stays = QFileInfo(first).fileName();
  QMessageBox box(
      QMessageBox::NoIcon, tr("Two scans"),
      tr("<b>Is %1 another scan of the same plant?</b>").arg(QFileInfo(second).fileName()),
      QMessageBox::NoButton, &parts_.window);
  box.setInformativeText(
      tr("Then register it: it is laid on %1, and the two can be joined. Or open "
         "%1 alone, as a plant of its own.")
          .arg(stays));
  QPushButton* registers = box.addButton(tr("Register"), QMessageBox::AcceptRole);
  const QPushButton* opens = box.addButton(tr("Open Alone"), QMessageBox::AcceptRole);
  box.setEscapeButton(box.addButton(tr("Cancel"), QMessageBox::RejectRole));
  box.setDefaultButton(registers);
  box.exec();
  if (box.clickedButton() == registers) return Second::registered;
  return box.clickedButton() == opens ? Second::opened : Second::left;
}

/// None where there is nothing to ask about.
std::optional<ScanLook> FileFlow::lookAt(const Opening& opening, const NamedColumns& known) {
  if (opening.look) return opening.look;
  std::optional<ScanLook> look = lookAtScan(opening.paths, opening.asking, known);
  if (look && opening.take) {
    look->unit = opening.unit;
    look->up = opening.up;
  }
  return look;
}

FileFlow::Read FileFlow::readOrAsk(Opening opening, const NamedColumns& known,
                                   const Progress& progress) {
  Read read{.unit = opening.unit, .up = opening.up};
  bool isByMemory = false;
  std::optional<ScanLook> look = lookAt(opening, known);
  if (look && !opening.chosen) {
    if (opening.asking == Asking::always || !look->failure.isEmpty() ||
        !questionsOf(*look, opening.request.mostAtOnce).isEmpty()) {
      read.look = std::move(look);
      return read;
    }
    opening.request.columns = look->columns;
    isByMemory = !look->columns.empty() && look->columns != look->text->columns;
  }
  try {
    read.files = loadFiles(opening.paths, opening.request, progress);
  } catch (const Error& error) {
    const bool isForThePage = look && opening.paths.size() == 1 && (look->text || opening.chosen);
    if (!isForThePage) throw;
    look->failure = shownText(error);
    look->chosen = opening.chosen;
    read.look = std::move(look);
    return read;
  }
  if (isByMemory)
    read.files.notes.append(
        tr("The columns are read as you named them before, of a file that begins alike"));
  return read;
}

void FileFlow::remember(const QString& alike, const std::vector<PointField>& columns) {
  if (alike.isEmpty()) return;
  if (columns.empty())
    named_.remove(alike);
  else
    named_[alike] = columns;
  keepNamedColumns(parts_.settings, named_);
}

void FileFlow::ask(Opening opening, const ScanLook& look) {
  ScanDialog dialog(look, opening.request.mostAtOnce, &parts_.window);
  JobSlot looks(parts_.jobs.queue(), JobPriority::asked);
  connect(&looks, &JobSlot::failed, &dialog, &ScanDialog::showProblem);
  connect(&dialog, &ScanDialog::columnsChosen, this, [&](const std::vector<PointField>& columns) {
    looks.start(
        [path = toPath(look.path), columns](const Progress&) { return glanceAt(path, columns); },
        [&dialog](const PointGlance& glance) { dialog.setGlance(glance); });
  });
  if (dialog.exec() != QDialog::Accepted) return emit noted(tr("Canceled: nothing has changed"));
  keepMostAtOnce(parts_.settings, dialog.mostAtOnce());
  remember(look.alike, dialog.remembersColumns() ? dialog.columns() : std::vector<PointField>());
  const ScanChoices choices = dialog.choices();
  const ReadOptions& reading = choices.reading;
  const std::uint64_t all = std::numeric_limits<std::uint64_t>::max();
  opening.request = {reading.box, reading.most > 0 ? reading.most : all, reading.columns};
  opening.asking = Asking::never;
  opening.unit = choices.unit;
  opening.up = choices.up;
  opening.look = look;
  opening.look->columns = dialog.columns();
  opening.look->glance = dialog.glance();
  opening.chosen = choices;
  parts_.actions.guarded(
      [&] {
        read(opening);
        return true;
      },
      Refusal::inBanner);
}

} // namespace espalier
