#include "app/window/review/seal_flow.h"

#include "app/window/files/file_filters.h"
#include "app/window/files/load_files.h"
#include "app/window/files/project_flow.h"
#include "app/window/frame/action_set.h"
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
  keepInProject({.name = "seal",
                 .text = [this] { return seal_ ? textOf(*seal_) : std::string(); },
                 .show =
                     [this](const std::string& text) {
                       set(text.empty() ? std::nullopt : std::optional(sealFrom(text)));
                     }});
  connect(&parts_.document, &PlantDocument::skeletonReplaced, this, [this] { set({}); });
  connect(&parts_.document, &PlantDocument::skeletonEdited, this,
          [this](const SkeletonDelta& delta) {
            if (hash_) hash_->apply(delta);
          });
  connect(&parts_.document.undoStack(), &QUndoStack::indexChanged, this, &SealFlow::follow);
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
    return (isBeforeSigned()
                ? tr("✗ Undone to before it was signed by %1: redo leads back to the seal.")
                : tr("✗ Seal broken: edited since it was signed by %1."))
        .arg(signature(*seal_));
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
  emit keptChanged();
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
    throw Error(
        tr("the seal does not hold: go back to what was signed, or sign again").toStdString());
  QFileDialog dialog(&parts_.window, tr("Export the seal"), {}, tr("Seals (*.json)"));
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix("json");
  proposeBeside(dialog, parts_.document, ".seal.json");
  if (dialog.exec() != QDialog::Accepted) return;
  const QString path = dialog.selectedFiles().front();
  writeAtomically(toPath(path), [this](std::ostream& out) { out << textOf(*seal_); });
  parts_.banner.showResult(tr("Wrote %1").arg(QFileInfo(path).fileName()));
}

void SealFlow::set(std::optional<Seal> seal) {
  seal_ = std::move(seal);
  hash_.reset();
  if (seal_) hash_.emplace(parts_.document.skeleton());
  wasIntact_ = isIntact();
  couldReturn_ = signedStep().has_value();
  warning_.clear();
  refresh();
}

void SealFlow::follow() {
  const bool hasBroken = std::exchange(wasIntact_, isIntact()) && !isIntact();
  const bool isWarning = !warning_.isEmpty() && parts_.banner.text() == warning_;
  if (isWarning && (isIntact() || !signedStep())) parts_.banner.hide();
  const bool isLost = std::exchange(couldReturn_, signedStep().has_value()) && !couldReturn_;
  if (hasBroken) warnOfBreak();
  if (isLost)
    parts_.banner.showOffer(tr("The seal of %1 is lost: what was signed can no longer be redone")
                                .arg(signature(*seal_)),
                            {});
  refresh();
}

void SealFlow::warnOfBreak() {
  const bool isBefore = isBeforeSigned();
  warning_ = (isBefore ? tr("This goes back to before the seal of %1. An edit from here loses it")
                       : tr("This breaks the seal of %1"))
                 .arg(signature(*seal_));
  parts_.banner.showOffer(warning_, {{isBefore ? tr("Redo") : tr("Undo"), [this] {
                                        const auto go = [this] {
                                          goToSigned();
                                          return true;
                                        };
                                        parts_.actions.guarded(go, Refusal::inBanner);
                                      }}});
}

void SealFlow::goToSigned() {
  if (const std::optional<int> step = signedStep()) parts_.document.goTo(*step);
}

std::optional<int> SealFlow::signedStep() const {
  const PlantDocument& document = parts_.document;
  const QUndoStack& stack = parts_.document.undoStack();
  if (!seal_ || isIntact()) return seal_ ? std::optional(stack.index()) : std::nullopt;
  StructureHash hash = *hash_;
  for (int i = stack.index(); i > 0; --i) {
    hash.apply(document.step(i - 1).delta.inverse());
    if (hash.value() == seal_->hash) return i - 1;
  }
  hash = *hash_;
  for (int i = stack.index(); i < stack.count(); ++i) {
    hash.apply(document.step(i).delta);
    if (hash.value() == seal_->hash) return i + 1;
  }
  return std::nullopt;
}

bool SealFlow::isBeforeSigned() const {
  return signedStep().value_or(0) > parts_.document.undoStack().index();
}

void SealFlow::refresh() {
  const bool hasNodes = !parts_.document.skeleton().isEmpty();
  parts_.actions["sign_structure"]->setEnabled(isEnabled_ && hasNodes);
  parts_.actions["export_seal"]->setEnabled(isIntact());
  emit changed();
}

} // namespace espalier
