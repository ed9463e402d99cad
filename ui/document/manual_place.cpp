#include "ui/document/manual_place.h"

#include <QVariant>
#include <QWidget>

namespace espalier {
namespace {

constexpr auto placeName = "manual_place";

} // namespace

void setManualPlace(QWidget& widget, const QString& place) {
  widget.setProperty(placeName, place);
}

QString manualPlaceOf(const QWidget* widget) {
  for (; widget != nullptr; widget = widget->parentWidget()) {
    const QString place = widget->property(placeName).toString();
    if (!place.isEmpty()) return place;
  }
  return {};
}

} // namespace espalier
