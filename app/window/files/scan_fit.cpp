#include "app/window/files/scan_fit.h"

#include <QCoreApplication>

namespace espalier {
namespace {

QString translated(const char* text) {
  return QCoreApplication::translate("ScanFit", text);
}

/// 266.41 as "266", 3.21 as "3.2".
QString formatFactor(double factor) {
  return formatLength(factor, LengthUnit::unknown, factor < 100 ? 2 : 3);
}

} // namespace

ScanFit fitOf(const Skeleton& skeleton, const PointCloud& cloud) {
  ScanFit fit{.shift = shiftOntoCloud(skeleton, cloud)};
  if (!fit.shift) fit.misfit = misfitOf(skeleton, cloud);
  return fit;
}

QString offerToMove(const QString& structure, const Eigen::Vector3d& shift, LengthUnit unit) {
  const auto text = [](double length) { return formatLength(length, LengthUnit::unknown); };
  const QString place = QStringLiteral("(%1, %2, %3)%4")
                            .arg(text(shift.x()), text(shift.y()), text(shift.z()),
                                 unit == LengthUnit::unknown ? QString() : ' ' + symbol(unit));
  return translated(
             QT_TRANSLATE_NOOP("ScanFit",
                               "%1 seems to be centered on the mean of the scan: move it by %2?"))
      .arg(structure, place);
}

QString describe(const Misfit& misfit, const QString& structure, const QString& scan) {
  if (!misfit.isOfOtherSize)
    return translated(
               QT_TRANSLATE_NOOP("ScanFit", "%1 lies outside of %2: is it of another plant?"))
        .arg(structure, scan);
  const QString size =
      misfit.size >= 1 ? translated(QT_TRANSLATE_NOOP("ScanFit", "%1 times as large"))
                             .arg(formatFactor(misfit.size))
      : misfit.size > 0 ? translated(QT_TRANSLATE_NOOP("ScanFit", "%1 times as small"))
                              .arg(formatFactor(1 / misfit.size))
                        : translated(QT_TRANSLATE_NOOP("ScanFit", "no more than one place"));
  return translated(QT_TRANSLATE_NOOP("ScanFit", "%1 does not lie on %2: it is %3; is it of "
                                                 "another plant, or in another unit?"))
      .arg(structure, scan, size);
}

} // namespace espalier
