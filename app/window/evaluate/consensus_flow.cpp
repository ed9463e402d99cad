#include "app/window/evaluate/consensus_flow.h"

#include "app/window/evaluate/reference_flow.h"
#include "app/window/files/project_flow.h"
#include "app/window/frame/action_set.h"
#include "core/base/error.h"
#include "ui/document/plant_document.h"
#include "ui/jobs/job_slot.h"

#include <QDateTime>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

namespace espalier {

ConsensusFlow::ConsensusFlow(const Parts& parts) : parts_(parts) {
  parts_.actions.beginSection(tr("Evaluate"));
  parts_.actions.add(
      {.id = "keep_agreed",
       .text = tr("&Keep What Both Agree On"),
       .help = tr("Consensus: leaves the wood that the plant and its reference both have; the rest "
                  "is then decided place by place"),
       .keys = QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_K),
       .menu = "file/reference"},
      [this] { find(); });
}

void ConsensusFlow::find() {
  PlantDocument& document = parts_.document;
  document.requireEditable();
  if (document.skeleton().isEmpty())
    throw Error(tr("there is no skeleton: make one first").toStdString());
  if (!parts_.reference.skeleton() || parts_.reference.isVersion())
    throw Error(tr("load what another expert has of this plant as the reference first (File > Load "
                   "Reference)")
                    .toStdString());
  if (!parts_.projects.isNamed())
    throw Error(tr("what you have is kept as a version, and only a project keeps versions: save "
                   "the plant as one first")
                    .toStdString());
  parts_.jobs.requireIdle();
  const auto plants = std::make_shared<const std::array<Skeleton, 2>>(
      std::array{document.skeleton(), parts_.reference.laid()});
  if (inOtherUnit(*plants))
    throw Error(tr("%1 is far larger or smaller than this plant: both have to be in one unit")
                    .arg(parts_.reference.name())
                    .toStdString());
  const auto agree = [plants](const Progress& progress) {
    return consensusOf(*plants, usualDistance(*plants), progress);
  };
  parts_.jobs.start(tr("Finding what both agree on"), agree,
                    [this, plants, other = parts_.reference.name()](const Consensus& consensus) {
                      parts_.actions.guarded(
                          [&] {
                            if (parts_.document.skeleton() != plants->front())
                              throw Error(
                                  tr("the plant was edited meanwhile: choose Keep What Both Agree "
                                     "On again")
                                      .toStdString());
                            keep(consensus, other);
                            return true;
                          },
                          Refusal::inBanner);
                    });
}

void ConsensusFlow::keep(const Consensus& consensus, const QString& other) {
  if (withoutAgreement(consensus))
    throw Error(tr("%1 has none of the wood of this plant where it lies: show the evaluation (F5), "
                   "which lays it on the plant, or check that both are of one scan")
                    .arg(other)
                    .toStdString());
  const auto inPercent = [&](std::size_t i) {
    return static_cast<int>(std::floor(100 * consensus.shares[i] + 1e-6));
  };
  if (consensus.places.empty()) {
    emit noted(tr("Both agree: there is no place to decide"));
    return;
  }
  parts_.document.requireEditable(); // or a version would be kept for nothing
  const QString before = freeName(tr("Before agreement with %1").arg(other));
  parts_.projects.addVersion({.name = before.toStdString(),
                              .author = parts_.projects.author().toStdString(),
                              .time = QDateTime::currentMSecsSinceEpoch(),
                              .skeleton = parts_.document.skeleton()});
  parts_.document.edit(tr("Keep What Both Agree On"),
                       [&](SkeletonEditor& editor) { keepAgreed(editor, consensus); });
  emit reported(
      {.text =
           tr("What both agree on is kept: %1 % of this plant, %2 % of %3. F3 leads to the "
              "rest of %3; for yours, compare with the version “%4”")
               .arg(QString::number(inPercent(0)), QString::number(inPercent(1)), other, before),
       .isStep = true});
}

QString ConsensusFlow::freeName(const QString& wanted) const {
  const auto isTaken = [&](const QString& name) {
    return std::ranges::count(parts_.projects.versions(), name.toStdString(), &PlantVersion::name) >
           0;
  };
  QString name = wanted;
  for (int number = 2; isTaken(name); ++number)
    name = wanted + QStringLiteral(" (%1)").arg(number);
  return name;
}

} // namespace espalier
