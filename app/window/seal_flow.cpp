#include "app/window/seal_flow.h"

#include "app/window/action_set.h"
#include "app/window/load_files.h"
#include "app/window/project_flow.h"
#include "core/base/error.h"
#include "core/io/atomic_file.h"
#include "ui/dialogs/sign_dialog.h"
#include "ui/document/hand_work_text.h"
#include "ui/document/plant_document.h"
#include "ui/panels/message_banner.h"

#include <QAction>
#include <QDateTime>
#include <QFileDialog>
#include <QFileInfo>
#include <QLocale>
#include <QMainWindow>

#include <ostream>
#include <utility>

namespace espalier {
namespace {

/// "Anna on 21 Nov 2026, 14:05"
QString signature(const Seal& seal) {
  const QDateTime time = QDateTime::fromMSecsSinceEpoch(seal.time);
  return SealFlow::tr("%1 on %2")
      .arg(QString::fromStdString(seal.author), QLocale::c().toString(time, "d MMM yyyy, HH:mm"));
}

} // namespace

SealFlow::SealFlow(const Parts& parts) : parts_(parts) {
  parts_.actions.beginSection(tr("Review"));
  parts_.actions.add({.id = "sign_structure",
                      .text = tr("Sign Structure…"),
                      .help = tr("Seals the structure once all of it is reviewed")},
                     [this] { sign(); });
  parts_.actions.add({.id = "export_seal",
                      .text = tr("Export Seal…"),
                      .help = tr("Writes who signed, when, and after what work, as JSON")},
                     [this] { exportSeal(); });
  parts_.projects.keep({.name = "seal",
                        .text = [this] { return seal_ ? textOf(*seal_) : std::string(); },
                        .show =
                            [this](const std::string& text) {
                              set(text.empty() ? std::nullopt : std::optional(sealFrom(text)));
                            }});
  connect(&parts_.document, &PlantDocument::skeletonReplaced, this, [this] { set({}); });
  connect(&parts_.document, &PlantDocument::skeletonEdited, this, &SealFlow::follow);
  connect(&parts_.document, &PlantDocument::titleChanged, this, &SealFlow::changed);
  refresh();
}

void SealFlow::setEnabled(bool isEnabled) {
  isEnabled_ = isEnabled;
  refresh();
}

QString SealFlow::text() const {
  if (!seal_) {
    const bool isInFile = !parts_.projects.isNamed() && !parts_.document.filePath().isEmpty();
    return isInFile ? tr("No seal: %1 cannot carry one, a project can.")
                          .arg(QFileInfo(parts_.document.filePath()).fileName())
                    : tr("Not signed yet.");
  }
  if (!isIntact())
    return tr("✗ Seal broken: edited since it was signed by %1.").arg(signature(*seal_));
  return tr("✓ Signed by %1.\nAt work: %2.\nCorrections: %3.")
      .arg(signature(*seal_), formatWorkTime(seal_->work.time), describe(seal_->work.corrections));
}

void SealFlow::sign() {
  PlantDocument& document = parts_.document;
  document.requireEditable();
  const History history = document.history();
  const auto now = [] { return QDateTime::currentMSecsSinceEpoch(); };
  const Seal draft = signedBy("?", now(), history); // refused before anything is asked
  SignDialog dialog(draft, document.unit(), signer_, &parts_.window);
  if (dialog.exec() != QDialog::Accepted) return;
  set(signedBy(dialog.signer().toStdString(), now(), history));
  parts_.projects.noteChange();
  emit signerChanged(dialog.signer());
  const QString done = tr("Signed by %1").arg(signature(*seal_));
  if (parts_.projects.isNamed())
    parts_.banner.showResult(done);
  else
    parts_.banner.showOffer(
        tr("%1. Only a project keeps the seal").arg(done),
        {{tr("Save Project As…"), [this] { parts_.actions["save_project_as"]->trigger(); }}});
}

void SealFlow::exportSeal() {
  if (!seal_) throw Error(tr("there is no seal yet: sign the structure first").toStdString());
  if (!isIntact())
    throw Error(tr("the seal is broken: undo what was edited, or sign again").toStdString());
  QFileDialog dialog(&parts_.window, tr("Export the seal"), {}, tr("Seals (*.json)"));
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix("json");
  const QFileInfo file(parts_.document.filePath());
  if (!parts_.document.filePath().isEmpty()) dialog.setDirectory(file.absolutePath());
  dialog.selectFile((file.fileName().isEmpty() ? tr("plant") : file.completeBaseName()) +
                    ".seal.json");
  if (dialog.exec() != QDialog::Accepted) return;
  const QString path = dialog.selectedFiles().front();
  writeAtomically(toPath(path), [this](std::ostream& out) { out << textOf(*seal_); });
  parts_.banner.showResult(tr("Wrote %1").arg(QFileInfo(path).fileName()));
}

void SealFlow::set(std::optional<Seal> seal) {
  seal_ = std::move(seal);
  hash_.reset();
  if (seal_) hash_.emplace(parts_.document.skeleton());
  intactStep_ = parts_.document.undoStack().index();
  told_.clear();
  refresh();
}

void SealFlow::follow(const SkeletonDelta& delta) {
  if (seal_) {
    const bool wasIntact = isIntact();
    hash_->apply(delta);
    if (wasIntact && !isIntact()) tellBroken();
    if (!wasIntact && isIntact() && parts_.banner.text() == told_) parts_.banner.hide();
  }
  refresh();
}

void SealFlow::tellBroken() {
  intactStep_ = parts_.document.undoStack().index(); // which this step has not left yet
  told_ = tr("This breaks the seal of %1").arg(signature(*seal_));
  parts_.banner.showOffer(told_, {{tr("Undo"), [this] {
                                     const auto undo = [this] {
                                       undoToSeal();
                                       return true;
                                     };
                                     parts_.actions.guarded(undo, Refusal::inBanner);
                                   }}});
}

/// Back to the step where the seal held; or by one, if that step is gone.
void SealFlow::undoToSeal() {
  parts_.document.requireEditable();
  QUndoStack& stack = parts_.document.undoStack();
  if (isIntact()) return;
  if (intactStep_ <= stack.count() && intactStep_ != stack.index())
    stack.setIndex(intactStep_);
  else
    stack.undo();
}

void SealFlow::refresh() {
  const bool hasNodes = !parts_.document.skeleton().isEmpty();
  parts_.actions["sign_structure"]->setEnabled(isEnabled_ && hasNodes);
  parts_.actions["export_seal"]->setEnabled(isIntact());
  emit changed();
}

} // namespace espalier
