#pragma once

#include "core/base/error.h"
#include "core/skeleton/skeleton.h"

#include <QJsonValue>
#include <QString>

#include <cmath>
#include <limits>

namespace espalier {

// Reads what a project keeps of the window, as JSON.

/// Thrown where it is not as it was written; readKept() warns the user.
struct NotAsWritten {};

[[noreturn]] inline void refuse() {
  throw NotAsWritten{};
}

[[nodiscard]] inline double numberIn(const QJsonValue& value) {
  const double number = value.toDouble(std::nan(""));
  if (!std::isfinite(number)) refuse();
  return number;
}

[[nodiscard]] inline NodeId nodeIn(const QJsonValue& value) {
  const double number = numberIn(value);
  if (number < 0 || number > std::numeric_limits<std::uint32_t>::max()) refuse();
  return NodeId{static_cast<std::uint32_t>(number)};
}

/// What `read` returns.
/// @throws Error `refusal`, which says what cannot be read and what to do, if it is refused
template <class Read> auto readKept(const QString& refusal, const Read& read) {
  try {
    return read();
  } catch (const NotAsWritten&) {
    throw Error(refusal.toStdString());
  }
}

} // namespace espalier
