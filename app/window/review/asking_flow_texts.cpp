#include "app/window/edit/editing.h"
#include "app/window/frame/action_set.h"
#include "app/window/frame/key_hints.h"
#include "app/window/review/asking_flow.h"
#include "ui/document/doubt_text.h"
#include "ui/document/length_unit.h"
#include "ui/document/plant_document.h"

#include <cmath>

namespace espalier {

/// "About 94 % of the length is right; 40 answers would make it 98 %."
QString AskingFlow::agreementText() const {
  const std::optional<ExpectedAgreement> expected = parts_.doubts.expected();
  if (!expected) return {};
  const auto percent = [](double share) { return std::lround(100 * share); };
  QString text = tr("About %1 % of the length is right").arg(percent(expected->share()));
  const std::size_t doubts = parts_.doubts.doubts().size();
  for (const double goal : {0.8, 0.85, 0.9, 0.95, 0.98, 0.99}) {
    if (goal < expected->share() + 0.01) continue;
    const std::size_t answers = parts_.doubts.answersFor(goal);
    if (answers > doubts) break;
    return text + (answers == 1 ? tr("; 1 answer would make it %1 %").arg(percent(goal))
                                : tr("; %1 answers would make it %2 %")
                                      .arg(formatCount(answers))
                                      .arg(percent(goal)));
  }
  return text;
}

QString AskingFlow::noteText() const {
  if (parts_.document.skeleton().isEmpty()) return tr("There is no skeleton to ask about yet");
  if (parts_.document.scan() == nullptr) return tr("Open a scan: doubts follow from its points");
  if (!parts_.doubts.hasSpacing())
    return tr("All points of the scan lie at one place: nothing can be asked about");
  if (!parts_.doubts.failure().isEmpty())
    return tr("The search for doubts did not end: %1.").arg(parts_.doubts.failure()) + ' ' +
           withKeys(tr("{ask_doubts} searches again"), parts_.actions);
  if (parts_.doubts.isBusy()) return tr("Looking for doubts…");
  if (parts_.doubts.isKnown() && parts_.doubts.doubts().empty()) return tr("Nothing is in doubt");
  return parts_.doubts.doubts().size() > mostListed ? tr("The first %1 are listed").arg(mostListed)
                                                    : QString();
}

QString AskingFlow::hint() const {
  if (isRestShown_)
    return withKeys(tr("Decide the Rest by Odds: once more makes the changes   {leave} drops them"),
                    parts_.actions);
  if (!isAsking_ || parts_.editing.isPending()) return {};
  if (isByHand_)
    return withKeys(tr("Correct it with any tool   {skip_doubt} goes on   {take_back_answer} takes "
                       "back   {leave} ends"),
                    parts_.actions);
  if (!current_) return withKeys(tr("Looking for doubts…   {leave} ends"), parts_.actions);
  QStringList parts;
  for (std::size_t i = 0; i < current_->alternatives.size(); ++i)
    parts.append(QString("%1 %2").arg(i + 1).arg(textOf(*current_, current_->alternatives[i])));
  parts.append(withKeys(
      tr("{answer_none} none   {skip_doubt} skip   {take_back_answer} back   {leave} ends"),
      parts_.actions));
  return parts.join("   ");
}

} // namespace espalier
