#include "ui/panels/radius_text.h"

#include <QCoreApplication>

namespace espalier {
namespace {

struct RadiusText {
  Q_DECLARE_TR_FUNCTIONS(RadiusText)
};

} // namespace

QString nameOf(RadiusSource source) {
  switch (source) {
  case RadiusSource::extrapolated:
    return RadiusText::tr("extrapolated");
  case RadiusSource::corrected:
    return RadiusText::tr("corrected");
  case RadiusSource::measured:
    return RadiusText::tr("measured");
  case RadiusSource::byHand:
    return RadiusText::tr("by hand");
  case RadiusSource::unknown:
    break;
  }
  return {};
}

QString originText(const Node& node, LengthUnit unit) {
  QString source = nameOf(node.origin.source);
  if (!node.origin.hasInterval()) return source;
  return RadiusText::tr("%1, %2 to %3")
      .arg(source, formatLength(node.origin.least * node.radius, LengthUnit::unknown, 2),
           formatLength(node.origin.most * node.radius, unit, 2));
}

} // namespace espalier
