#include "ui/document/doubt_text.h"

#include <QCoreApplication>

namespace espalier {
namespace {

class DoubtText {
  Q_DECLARE_TR_FUNCTIONS(DoubtText)
};

} // namespace

QString nameOfOne(Doubt::Kind kind) {
  switch (kind) {
  case Doubt::Kind::end:
    return DoubtText::tr("No wood?");
  case Doubt::Kind::attachment:
    return DoubtText::tr("Grows elsewhere?");
  case Doubt::Kind::missing:
    return DoubtText::tr("Missing branch?");
  }
  return {};
}

QString questionOf(const Doubt& doubt, LengthUnit unit) {
  const QString length = formatLength(doubt.length, unit, 2);
  switch (doubt.kind) {
  case Doubt::Kind::end:
    return DoubtText::tr("Is this branch wood? %1 long").arg(length);
  case Doubt::Kind::attachment:
    return DoubtText::tr("What does this branch grow from? %1 long").arg(length);
  case Doubt::Kind::missing:
    return DoubtText::tr("Is there a branch along these points? %1 long").arg(length);
  }
  return {};
}

QString textOf(const Doubt& doubt, const Alternative& alternative) {
  switch (alternative.kind) {
  case Alternative::Kind::asItIs:
    return doubt.kind == Doubt::Kind::missing ? DoubtText::tr("no branch")
                                              : DoubtText::tr("as it is");
  case Alternative::Kind::remove:
    return DoubtText::tr("no wood");
  case Alternative::Kind::attach:
    return DoubtText::tr("from node %1").arg(indexOf(*alternative.onto));
  case Alternative::Kind::add:
    return DoubtText::tr("a branch");
  }
  return {};
}

std::vector<std::size_t> numbered(const Doubt& doubt) {
  std::vector<std::size_t> order = {doubt.present};
  for (std::size_t i = 0; i < doubt.alternatives.size(); ++i)
    if (i != doubt.present) order.push_back(i);
  return order;
}

} // namespace espalier
