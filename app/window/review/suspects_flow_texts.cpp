#include "app/window/frame/action_set.h"
#include "app/window/review/asking_flow.h"
#include "app/window/review/finding_remedy.h"
#include "app/window/review/findings_flow.h"
#include "app/window/review/suspects_flow.h"
#include "ui/document/doubt_text.h"
#include "ui/document/finding_title.h"
#include "ui/document/plant_document.h"
#include "ui/document/shown_message.h"
#include "ui/panels/suspects_panel.h"

#include <QAction>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace espalier {
namespace {

long percentOf(double share) {
  return std::lround(100 * share);
}

} // namespace

double SuspectsFlow::spacing() const {
  const Scan* scan = parts_.document.scan();
  return scan != nullptr ? scan->spacing() : 0;
}

/// Short: the kind is written over it, and the whole sentence is its tool tip.
QString SuspectsFlow::placeText(const Finding& finding) const {
  using Kind = Finding::Kind;
  const auto length = [this](double value) {
    return formatLength(value, parts_.document.unit(), 2);
  };
  QString node = QString::number(indexOf(finding.node));
  const qulonglong other = finding.others.empty() ? 0 : indexOf(finding.others.front());
  const qlonglong count = std::llround(finding.amount);
  switch (finding.kind) {
  case Kind::separatePiece:
    return count == 1 ? tr("%1 · alone").arg(node) : tr("%1 · %2 nodes").arg(node).arg(count);
  case Kind::twoSuccessors:
    return tr("%1 · %2").arg(node).arg(count);
  case Kind::loneBranch:
  case Kind::noLength:
    return node;
  case Kind::duplicatedEdge:
    return tr("%1 on %2").arg(node).arg(other);
  case Kind::sharpTurn:
    return tr("%1 · %2°").arg(node).arg(std::lround(finding.amount * 180 / std::numbers::pi));
  case Kind::crossing:
  case Kind::loop:
    return tr("%1 and %2").arg(node).arg(other);
  case Kind::radiusAboveParent:
  case Kind::edgesWithoutPoints:
  case Kind::noOwnPoints:
  case Kind::besidePoints:
  case Kind::shortFoot:
    return tr("%1 · %2").arg(node, length(finding.amount));
  case Kind::unexplainedPoints:
    return tr("%1 · %2").arg(node, length(2 * finding.reach));
  }
  return {};
}

SuspectText SuspectsFlow::textOf(const Suspect& suspect) const {
  const auto whole = [&](const QString& sentence) {
    return tr("%1\n%2 of the skeleton, wrong with a probability of %3 %")
        .arg(sentence, formatLength(suspect.length, parts_.document.unit(), 2))
        .arg(percentOf(suspect.wrong));
  };
  if (suspect.isDoubt()) {
    const Doubt& doubt = doubtOf(suspect);
    const QString length = formatLength(doubt.length, parts_.document.unit(), 2);
    return {.title = nameOfOne(doubt.kind),
            .place = tr("%1 · %2").arg(indexOf(doubt.node)).arg(length),
            .remedy = tr("Enter"),
            .whole = whole(suspect.twin ? sentenceOf(doubt) + QStringLiteral("\n") +
                                              describedBy(parts_.findings.findings()[*suspect.twin])
                                        : sentenceOf(doubt))};
  }
  const Finding& finding = findingOf(suspect);
  const Skeleton& skeleton = parts_.document.skeleton();
  const Remedy remedy = remedyOf(finding, skeleton, spacing());
  return {.title = nameOfOne(finding.kind),
          .place = placeText(finding),
          .remedy = parts_.actions[remedy.action]->shortcut().toString(QKeySequence::NativeText),
          .whole = whole(sentenceOf(finding))};
}

QString SuspectsFlow::describedBy(const Finding& finding) const {
  const auto length = [this](double value) {
    return formatLength(value, parts_.document.unit(), 3).toStdString();
  };
  const auto count = [](std::size_t number) { return formatCount(number).toStdString(); };
  QString whole = shownText(describe(finding, parts_.document.skeleton(), {length, count}));
  whole[0] = whole[0].toUpper();
  return whole;
}

/// What it is, its number, and the key that does something about it.
QString SuspectsFlow::sentenceOf(const Finding& finding) const {
  const QString whole = describedBy(finding);
  const Remedy remedy = remedyOf(finding, parts_.document.skeleton(), spacing());
  const QKeySequence key = parts_.actions[remedy.action]->shortcut();
  return tr("%1: %2 %3").arg(whole, key.toString(QKeySequence::NativeText), remedy.does);
}

QString SuspectsFlow::sentenceOf(const What& what) const {
  if (std::holds_alternative<Doubt>(what))
    return tr("%1: Enter asks").arg(questionOf(std::get<Doubt>(what), parts_.document.unit()));
  return sentenceOf(std::get<Finding>(what));
}

QString SuspectsFlow::titleText() const {
  if (parts_.document.skeleton().isEmpty()) return tr("There is no skeleton to check yet");
  if (showsIgnored())
    return ignoredCount_ == 1 ? tr("1 place is ignored")
                              : tr("%1 places are ignored").arg(formatCount(ignoredCount_));
  if (count_ > 0)
    return count_ == 1 ? tr("1 place may be wrong")
                       : tr("%1 places may be wrong").arg(formatCount(count_));
  const bool isOver = parts_.findings.isAllChecked() && !parts_.doubts.isBusy();
  if (!isOver) return tr("Nothing to look at so far");
  return ignoredCount_ == 0 ? tr("Nothing to look at: all checks pass")
         : ignoredCount_ == 1
             ? tr("Nothing else to look at: 1 place is ignored")
             : tr("Nothing else to look at: %1 places are ignored").arg(formatCount(ignoredCount_));
}

QString SuspectsFlow::noteText() const {
  if (parts_.document.skeleton().isEmpty()) return {};
  if (parts_.document.scan() == nullptr)
    return tr("Open a scan to check against it, and to find what is in doubt");
  if (!parts_.doubts.hasSpacing())
    return tr("All points of the scan lie at one place: nothing can be asked about");
  if (!parts_.doubts.failure().isEmpty()) return parts_.asking.failureText();
  if (!parts_.findings.isAllChecked()) return tr("Checking against the scan…");
  if (parts_.doubts.isBusy()) return tr("Looking for doubts…");
  return count_ > 0 && panel_->suspects().empty() ? tr("None of them is of this kind and part")
                                                  : QString();
}

/// "About 94 % of the length is right; 40 answers would make it 98 %."
QString SuspectsFlow::agreementText() const {
  const std::optional<ExpectedAgreement> expected = parts_.doubts.expected();
  if (!expected || parts_.document.skeleton().isEmpty()) return {};
  QString text = tr("About %1 % of the length is right").arg(percentOf(expected->share()));
  const std::size_t doubts = parts_.doubts.doubts().size();
  for (const double goal : {0.8, 0.85, 0.9, 0.95, 0.98, 0.99}) {
    if (goal < expected->share() + 0.01) continue;
    const std::size_t answers = parts_.doubts.answersFor(goal);
    if (answers > doubts) break;
    return text + (answers == 1 ? tr("; 1 answer would make it %1 %").arg(percentOf(goal))
                                : tr("; %1 answers would make it %2 %")
                                      .arg(formatCount(answers))
                                      .arg(percentOf(goal)));
  }
  return text;
}

void SuspectsFlow::refreshTexts() {
  const Skeleton& skeleton = parts_.document.skeleton();
  panel_->showTitle(titleText());
  panel_->showNote(noteText());
  const auto isThere = [&](const Finding& finding) {
    return std::ranges::all_of(nodesOf(finding), [&](NodeId id) { return skeleton.contains(id); });
  };
  const bool isShown = current_ && (std::holds_alternative<Doubt>(*current_) ||
                                    isThere(std::get<Finding>(*current_)));
  panel_->showSentence(isShown ? sentenceOf(*current_) : QString());
}

void SuspectsFlow::refreshAgreement() {
  const bool isOfNow = !parts_.doubts.isBusy();
  if (isOfNow) agreement_ = agreementText();
  panel_->showAgreement(agreement_, isOfNow);
  refreshTexts();
}

/// The command says what it will do.
void SuspectsFlow::showAction() {
  const auto row = panel_->current();
  const bool isIgnored = row && panel_->suspects()[*row].isIgnored();
  const bool isDoubt = row && panel_->suspects()[*row].isDoubt();
  parts_.actions["ignore_finding"]->setText(
      isDoubt ? (isIgnored ? tr("Show Doubt Again") : tr("Ignore Doubt"))
              : (isIgnored ? tr("Show Finding Again") : tr("Ignore Finding")));
  QAction* ignore = parts_.actions["ignore_finding"];
  ignore->setIconText(isIgnored ? tr("Show Again") : ignore->text());
}

} // namespace espalier
