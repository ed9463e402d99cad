#include "app/window/review/seal_flow.h"

#include "app/report/certificate.h"
#include "app/report/write_report.h"
#include "app/window/files/file_filters.h"
#include "app/window/files/load_files.h"
#include "app/window/files/project_flow.h"
#include "app/window/files/reported_plant.h"
#include "app/window/frame/action_set.h"
#include "app/window/frame/key_hints.h"
#include "app/window/frame/scan_distances.h"
#include "core/base/error.h"
#include "core/io/atomic_file.h"
#include "core/skeleton/review_coverage.h"
#include "ui/dialogs/sign_dialog.h"
#include "ui/document/hand_work_text.h"
#include "ui/document/plant_document.h"
#include "ui/document/seal_text.h"
#include "ui/jobs/job_slot.h"
#include "ui/panels/message_banner.h"

#include <QAction>
#include <QCoreApplication>
#include <QDateTime>
#include <QFileDialog>
#include <QFileInfo>
#include <QMainWindow>

#include <memory>
#include <ostream>
#include <utility>

namespace espalier {

SealFlow::SealFlow(const Parts& parts) : parts_(parts), maker_(parts.jobs) {
  parts_.actions.beginSection(tr("Review"));
  parts_.actions.add({.id = "sign_structure",
                      .text = tr("Sign Structure…"),
                      .help = tr("Seals the structure once all of it is reviewed")},
                     [this] { sign(); });
  parts_.actions.add({.id = "export_seal",
                      .text = tr("Export Seal…"),
                      .help = tr("Writes who signed, when, and after what work, as JSON")},
                     [this] { exportSeal(); });
  parts_.actions.add({.id = "export_certificate",
                      .text = tr("Export Certificate…"),
                      .help = tr("Writes one page on the signed structure, with pictures: who "
                                 "signed, what was open, how it agrees with others")},
                     [this] { chooseCertificate(); });
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
  connect(&maker_, &ReportMaker::busyChanged, this, &SealFlow::refresh);
  connect(&maker_, &ReportMaker::noted, this, &SealFlow::noted);
  connect(&maker_, &ReportMaker::written, this, [this](const QString& path) {
    emit reported(offerToOpen(path, [this](const QString& text) { emit failed(text); }));
  });
  refresh();
}

void SealFlow::setEnabled(bool isEnabled) {
  isEnabled_ = isEnabled;
  refresh();
}

QString SealFlow::text() const {
  if (!seal_) {
    const bool isInFile = !parts_.projects.isNamed() && !parts_.document.filePath().isEmpty();
    return isInFile ? tr("Not signed yet. A project keeps the seal, a file does not.")
                    : tr("Not signed yet.");
  }
  if (!isIntact())
    return (isBeforeSigned()
                ? tr("✗ Undone to before it was signed by %1: redo leads back to the seal.")
                : tr("✗ Seal broken: edited since it was signed by %1."))
        .arg(signatureOf(*seal_));
  QString text = tr("✓ Signed by %1.\nAt work: %2.\nCorrections: %3.")
                     .arg(signatureOf(*seal_), formatWorkTime(seal_->work.time),
                          describe(seal_->work.corrections));
  if (seal_->state) text += tr("\nFindings: %1.").arg(findingsText(*seal_->state));
  if (seal_->review && seal_->review->inBulk.nodes > 0)
    text += tr("\nMarked in bulk: %1 of %2 nodes.")
                .arg(formatCount(seal_->review->inBulk.nodes), formatCount(seal_->nodes));
  return text;
}

void SealFlow::sign() {
  PlantDocument& document = parts_.document;
  document.requireEditable();
  parts_.jobs.requireIdle();
  const History history = document.history();
  requireReviewed(history.skeleton);
  static_cast<void>(signedBy("?", 0, history)); // refused before anything is found or asked
  ToSeal from{.plant = history.skeleton, .beginning = beginningOfHandWork(history)};
  std::shared_ptr<const PointCloud> all;
  PointSet leftOut;
  if (const Scan* scan = document.scan()) {
    all = scan->cloud();
    leftOut = scan->leftOut();
    from.spacing = scan->spacing();
  }
  parts_.addKnown(from);
  parts_.jobs.start(
      tr("Looking at what is signed"),
      [from = std::move(from), all, leftOut](const Progress& progress) mutable {
        if (all) from.points = pointsWithout(all, leftOut);
        return sealedFacts(from, progress);
      },
      [this, hash = StructureHash(history.skeleton).value()](SealedFacts facts) {
        parts_.jobs.afterwards([this, hash, facts = std::move(facts)]() mutable {
          const auto ask = [&] {
            if (StructureHash(parts_.document.skeleton()).value() != hash)
              throw Error(tr("the structure was edited meanwhile: sign it again").toStdString());
            askToSign(std::move(facts));
            return true;
          };
          parts_.actions.guarded(ask, Refusal::inBanner);
        });
      });
}

/// @throws Error that names the key to what is left
void SealFlow::requireReviewed(const Skeleton& plant) const {
  const ReviewCoverage seen = coverage(plant);
  if (seen.isComplete() || seen.totalNodes() == 0) return;
  const std::size_t doubtful = seen.nodes[static_cast<std::size_t>(ReviewState::doubtful)];
  const std::size_t open =
      seen.totalNodes() - seen.nodes[static_cast<std::size_t>(ReviewState::reviewed)];
  const QString left = formatCount(open);
  const QString all = formatCount(seen.totalNodes());
  const QString text =
      doubtful == open
          ? tr("%1 of %2 nodes are doubtful: {next_not_reviewed} goes to the next").arg(left, all)
      : doubtful == 0 ? tr("%1 of %2 nodes are not reviewed: {next_not_reviewed} goes to the next")
                            .arg(left, all)
                      : tr("%1 of %2 nodes are not reviewed, %3 of them doubtful: "
                           "{next_not_reviewed} goes to the next")
                            .arg(left, all, formatCount(doubtful));
  throw Error(withKeys(text, parts_.actions).toStdString());
}

void SealFlow::askToSign(SealedFacts facts) {
  PlantDocument& document = parts_.document;
  for (const Finding& finding : facts.findings) {
    if (!parts_.isIgnored(finding)) {
      ++facts.state.findings[nameOf(finding.kind)];
      continue;
    }
    ++facts.state.ignored;
    if (finding.kind != Finding::Kind::unexplainedPoints) continue;
    ++facts.state.ignoredPlaces;
    facts.state.ignoredPoints += finding.points.size();
  }
  facts.state.questions = parts_.questions();
  const History history = document.history();
  const auto now = [] { return QDateTime::currentMSecsSinceEpoch(); };
  SignDialog dialog(signedBy("?", now(), history, facts.state), document.unit(), signer_,
                    &parts_.window);
  if (dialog.exec() != QDialog::Accepted) return;
  facts.state.reason = dialog.reason().toStdString();
  set(signedBy(dialog.signer().toStdString(), now(), history, std::move(facts.state)));
  emit keptChanged();
  emit signerChanged(dialog.signer());
  const QString done = tr("Signed by %1").arg(signatureOf(*seal_));
  const auto offer = [this](const char* action) {
    return BannerAction{parts_.actions[action]->text(),
                        [this, action] { parts_.actions[action]->trigger(); }};
  };
  if (parts_.projects.isNamed())
    parts_.banner.showOffer(done, {offer("export_certificate")});
  else
    parts_.banner.showOffer(tr("%1. Only a project keeps the seal").arg(done),
                            {offer("save_project_as"), offer("export_certificate")});
}

void SealFlow::requireIntact() const {
  if (!seal_) throw Error(tr("there is no seal yet: sign the structure first").toStdString());
  if (!isIntact())
    throw Error(
        tr("the seal does not hold: go back to what was signed, or sign again").toStdString());
}

void SealFlow::exportSeal() {
  requireIntact();
  QFileDialog dialog(&parts_.window, tr("Export the seal"), {}, tr("Seals (*.json)"));
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix("json");
  proposeBeside(dialog, parts_.document, ".seal.json");
  if (dialog.exec() != QDialog::Accepted) return;
  const QString path = dialog.selectedFiles().front();
  writeAtomically(toPath(path), [this](std::ostream& out) { out << textOf(*seal_); });
  parts_.banner.showResult(tr("Wrote %1").arg(QFileInfo(path).fileName()));
}

void SealFlow::chooseCertificate() {
  requireIntact();
  QFileDialog dialog(&parts_.window, tr("Export the certificate"), {},
                     tr("PDF (*.pdf);;Web pages (*.html)"));
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix("pdf");
  proposeBeside(dialog, parts_.document, ".certificate.pdf");
  if (dialog.exec() == QDialog::Accepted) writeCertificate(dialog.selectedFiles().front());
}

void SealFlow::writeCertificate(const QString& path) {
  maker_.requireIdle();
  requireReportName(toPath(path));
  requireWritable(toPath(path));
  const PlantDocument& document = parts_.document;
  const Scan* scan = document.scan();
  auto about = std::make_shared<CertificateAbout>(
      CertificateAbout{.plant = reportedPlant(document),
                       .scan = reportedScan(document),
                       .version = QCoreApplication::applicationVersion(),
                       .unit = document.unit(),
                       .comments = commentsOf(document.skeleton())});
  parts_.jobs.start(
      tr("Looking at the scan for the certificate"),
      [about, file = toPath(document.scanPath())](const Progress& progress) {
        identifyScan(about->scan, file, progress);
        return 0;
      },
      [this, path, about, seal = *seal_, plant = document.skeleton(), up = document.up(),
       points = scan != nullptr ? scan->cloud() : nullptr](int) {
        parts_.jobs.afterwards([this, path, about, seal, plant, up, points] {
          maker_.start(path,
                       std::make_unique<PictureSession>(plant, points, up, symbol(about->unit)),
                       [path, about, seal](const ReportPictures& pictures) {
                         writeReport(toPath(path), certificate(seal, pictures, *about));
                       });
        });
      });
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
                                .arg(signatureOf(*seal_)),
                            {});
  refresh();
}

void SealFlow::warnOfBreak() {
  const bool isBefore = isBeforeSigned();
  warning_ = (isBefore ? tr("This goes back to before the seal of %1. An edit from here loses it")
                       : tr("This breaks the seal of %1"))
                 .arg(signatureOf(*seal_));
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
  parts_.actions["export_certificate"]->setEnabled(isIntact() && !maker_.isBusy());
  emit changed();
}

} // namespace espalier
