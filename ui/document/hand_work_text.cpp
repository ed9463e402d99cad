#include "ui/document/hand_work_text.h"

#include "ui/document/length_unit.h"
#include "ui/document/plant_document.h"

#include <QCoreApplication>
#include <QStringList>

#include <span>

namespace espalier {
namespace {

struct HandWorkText {
  Q_DECLARE_TR_FUNCTIONS(HandWork)
};

} // namespace

HandWork handWork(const PlantDocument& document) {
  const History history = document.history();
  return handWork(std::span(history.steps).first(history.position), history.skeleton);
}

MadeByHand madeByHand(const PlantDocument& document) {
  const auto stepAt = [&](std::size_t i) -> const HistoryStep& {
    return document.step(static_cast<int>(i));
  };
  return madeByHand(stepAt, static_cast<std::size_t>(document.undoStack().index()),
                    document.skeleton());
}

QString formatWorkTime(std::int64_t milliseconds) {
  const std::int64_t minutes = milliseconds / 60'000;
  if (minutes < 1) return HandWorkText::tr("under a minute");
  if (minutes < 60) return HandWorkText::tr("%1 min").arg(minutes);
  return HandWorkText::tr("%1 h %2 min").arg(minutes / 60).arg(minutes % 60);
}

QString describe(const Corrections& corrections) {
  if (corrections.edits == 0) return HandWorkText::tr("none");
  QStringList kinds;
  const auto add = [&](std::size_t count, const QString& text) {
    if (count > 0) kinds.append(text.arg(formatCount(count)));
  };
  add(corrections.added, HandWorkText::tr("%1 added"));
  add(corrections.removed, HandWorkText::tr("%1 removed"));
  add(corrections.moved, HandWorkText::tr("%1 moved"));
  add(corrections.reparented, HandWorkText::tr("%1 reparented"));
  add(corrections.retyped, HandWorkText::tr("%1 with another edge type"));
  add(corrections.radii, HandWorkText::tr("%1 with another radius"));
  const QString edits = corrections.edits == 1
                            ? HandWorkText::tr("1 edit")
                            : HandWorkText::tr("%1 edits").arg(formatCount(corrections.edits));
  return HandWorkText::tr("%1; nodes: %2").arg(edits, kinds.join(", "));
}

} // namespace espalier
