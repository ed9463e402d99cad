#include "ui/document/difference_look.h"

#include <QCoreApplication>

namespace espalier {
namespace {

struct DifferenceText {
  Q_DECLARE_TR_FUNCTIONS(Differences)
};

} // namespace

QString titleOf(Difference difference) {
  switch (difference) {
  case Difference::matched:
    return DifferenceText::tr("Matched");
  case Difference::missed:
    return DifferenceText::tr("Missed");
  case Difference::invented:
    return DifferenceText::tr("Invented");
  case Difference::wronglyAttached:
    return DifferenceText::tr("Wrongly attached");
  }
  return {};
}

Color colorOf(Difference difference) {
  switch (difference) {
  case Difference::missed:
    return {0x1b, 0x87, 0xd0};
  case Difference::invented:
    return {0xd5, 0x5e, 0x00};
  case Difference::wronglyAttached:
    return {0xcc, 0x79, 0xa7};
  case Difference::matched:
    break;
  }
  return {0x8c, 0x91, 0x8f};
}

} // namespace espalier
