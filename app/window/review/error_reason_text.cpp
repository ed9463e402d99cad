#include "app/window/review/error_reason_text.h"

#include "core/decide/error_reasons.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace espalier {
namespace {

class ErrorReasonText {
  Q_DECLARE_TR_FUNCTIONS(ErrorReasonText)

public:
  ErrorReasonText(const ErrorEvidence& evidence, double spacing, LengthUnit unit)
      : evidence_(evidence), spacing_(spacing), unit_(unit) {}

  [[nodiscard]] QString of(ErrorReason::Kind kind) const {
    switch (kind) {
    case ErrorReason::Kind::inAir:
      return tr("no point is near %1 of it").arg(percent(evidence_.inAir));
    case ErrorReason::Kind::noPointsOfItsOwn:
      return tr("its first %1 have no points of their own").arg(length(evidence_.withoutOwn));
    case ErrorReason::Kind::scatter:
      return tr("its points lie %1 off its surface").arg(length(evidence_.scatter));
    case ErrorReason::Kind::fewPoints:
      return tr("%1 points lie on %2 of it")
          .arg(formatCount(static_cast<std::size_t>(evidence_.points)), length(evidence_.length));
    case ErrorReason::Kind::unexplained:
      return tr("%1 points beside it belong to no wood")
          .arg(formatCount(static_cast<std::size_t>(evidence_.unexplained)));
    case ErrorReason::Kind::beside:
      return evidence_.beside > 0 ? tr("other wood is %1 from it").arg(length(evidence_.beside))
                                  : tr("it lies in other wood");
    case ErrorReason::Kind::turn:
      return tr("it turns by %1° where it begins").arg(std::lround(turn()));
    case ErrorReason::Kind::findings:
      return tr("the checks find its shape unlikely");
    case ErrorReason::Kind::end:
      return evidence_.isEnd
                 ? tr("its end is a shoot with a probability of %1 only").arg(percent(shoot()))
                 : tr("it bears further wood");
    case ErrorReason::Kind::gap:
      return tr("with a probability of %1, it belongs elsewhere than across the gap below it")
          .arg(percent(evidence_.gap));
    case ErrorReason::Kind::extent:
      return tr("branches of this size are often wrong");
    case ErrorReason::Kind::radius:
      return tr("wood of this radius (%1) is often wrong").arg(length(evidence_.radius));
    }
    return {};
  }

private:
  [[nodiscard]] static QString percent(double share) {
    return tr("%1 %").arg(std::lround(100 * share));
  }
  [[nodiscard]] QString length(double spacings) const {
    return formatLength(spacings * spacing_, unit_, 2);
  }
  [[nodiscard]] double turn() const { // [degrees]
    return std::acos(std::clamp(evidence_.turn, -1.0, 1.0)) * 180 / std::numbers::pi;
  }
  [[nodiscard]] double shoot() const { return 1 / (1 + std::exp(-evidence_.end)); }

  const ErrorEvidence& evidence_;
  double spacing_;
  LengthUnit unit_;
};

} // namespace

QString textOfReasons(const ErrorEvidence& evidence, double spacing, LengthUnit unit) {
  constexpr std::size_t most = 2;
  const ErrorReasonText text(evidence, spacing, unit);
  const std::vector<ErrorReason> reasons = reasonsFor(evidence);
  QStringList phrases;
  for (const ErrorReason& reason : reasons)
    if (phrases.size() < static_cast<qsizetype>(most)) phrases.append(text.of(reason.kind));
  return phrases.join(ErrorReasonText::tr("; "));
}

} // namespace espalier
