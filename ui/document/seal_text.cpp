#include "ui/document/seal_text.h"

#include "core/skeleton/finding.h"
#include "ui/document/finding_title.h"
#include "ui/document/hand_work_text.h"
#include "ui/document/number_scale.h"
#include "ui/document/time_text.h"

#include <QCoreApplication>
#include <QStringList>

#include <utility>

namespace espalier {
namespace {

struct SealText {
  Q_DECLARE_TR_FUNCTIONS(Seal)
};

QString amountText(const ReviewRecord::Amount& amount, LengthUnit unit) {
  const QString length = formatLength(amount.length, unit);
  return amount.nodes == 1 ? SealText::tr("1 node, %1").arg(length)
                           : SealText::tr("%1 nodes, %2").arg(formatCount(amount.nodes), length);
}

QString questionsText(const SealedQuestions& questions) {
  const QString answered = formatCount(questions.answered);
  return questions.open
             ? SealText::tr("%1 answered, %2 open").arg(answered, formatCount(*questions.open))
             : SealText::tr("%1 answered").arg(answered);
}

QString agreementText(const SealedAgreement& agreement, LengthUnit unit) {
  const auto share = [](double value) { return numberText(value, 3); };
  return SealText::tr("F %1 within %2 (precision %3, recall %4), T %5")
      .arg(share(agreement.f), formatLength(agreement.distance, unit, 2),
           share(agreement.precision), share(agreement.recall),
           agreement.structural ? share(*agreement.structural) : QStringLiteral("–"));
}

/// In one line, however much there is: a certificate is one page.
QString unexplainedText(const SealedState& state) {
  const auto share = [&](std::size_t points) { // of few points, too, it is not 0
    const double percent = 100 * static_cast<double>(points) / static_cast<double>(state.points);
    return numberText(percent, percent < 0.1 && points > 0 ? 3 : 1);
  };
  QString text =
      SealText::tr("%1 of %2 (%3 %)")
          .arg(formatCount(state.unexplained), formatCount(state.points), share(state.unexplained));
  if (state.ignoredPlaces == 0) return text;
  const QString points = formatCount(state.ignoredPoints);
  return text +
         (state.ignoredPlaces == 1
              ? SealText::tr("; at 1 place ignored as no wood: %1 (%2 %)")
                    .arg(points, share(state.ignoredPoints))
              : SealText::tr("; at %1 places ignored as no wood: %2 (%3 %)")
                    .arg(formatCount(state.ignoredPlaces), points, share(state.ignoredPoints)));
}

} // namespace

QString findingsText(const SealedState& state) {
  QStringList kinds;
  for (int i = 0; i < findingKinds; ++i) {
    const auto kind = static_cast<Finding::Kind>(i);
    const auto found = state.findings.find(nameOf(kind));
    if (found == state.findings.end() || found->second == 0) continue;
    QString title = titleOf(kind);
    title[0] = title[0].toLower();
    kinds.append(SealText::tr("%1: %2").arg(title, formatCount(found->second)));
  }
  QString text =
      kinds.isEmpty()
          ? SealText::tr("none is open")
          : SealText::tr("%1 open (%2)").arg(formatCount(state.openFindings()), kinds.join(", "));
  if (state.ignored > 0) text += SealText::tr("; %1 ignored").arg(formatCount(state.ignored));
  return text;
}

QString signatureOf(const Seal& seal) {
  return SealText::tr("%1 on %2").arg(QString::fromStdString(seal.author), momentText(seal.time));
}

std::vector<SealRow> sealRows(const Seal& seal, LengthUnit unit) {
  std::vector<SealRow> rows;
  const auto add = [&](const QString& name, const QString& text) { rows.push_back({name, text}); };
  add(SealText::tr("Structure"), amountText({seal.nodes, seal.length}, unit));
  add(SealText::tr("At work"), SealText::tr("%1, pauses over %2 min left out")
                                   .arg(formatWorkTime(seal.work.time))
                                   .arg(longestPause / 60'000));
  add(SealText::tr("Corrections"), describe(seal.work.corrections));
  if (seal.review) {
    const ReviewRecord& review = *seal.review;
    add(SealText::tr("Looked at"), amountText(review.lookedAt, unit));
    if (review.inBulk.nodes > 0)
      add(SealText::tr("Marked in bulk"), amountText(review.inBulk, unit));
    if (review.before.nodes > 0)
      add(SealText::tr("Marked before it was opened"), amountText(review.before, unit));
    if (review.doubted.nodes > 0)
      add(SealText::tr("Doubtful before"), amountText(review.doubted, unit));
    if (review.comments > 0)
      add(SealText::tr("Places with a comment"), formatCount(review.comments));
  }
  if (!seal.state) return rows;
  const SealedState& state = *seal.state;
  add(SealText::tr("Findings"), findingsText(state));
  if (!state.reason.empty())
    add(SealText::tr("Why they are left"), QString::fromStdString(state.reason));
  if (state.questions) add(SealText::tr("Questions"), questionsText(*state.questions));
  if (state.points > 0) add(SealText::tr("Points without wood"), unexplainedText(state));
  for (const auto& agreement : {state.automatic, state.other})
    if (agreement)
      add(SealText::tr("Agreement with %1").arg(QString::fromStdString(agreement->with)),
          agreementText(*agreement, unit));
  return rows;
}

} // namespace espalier
