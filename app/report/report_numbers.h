#pragma once

#include "core/evaluate/study/ranking.h"

#include <QString>

#include <cstddef>

namespace espalier {

/// Numbers as a report writes them: the same value is written the same everywhere in it.
class ReportNumbers {
public:
  explicit ReportNumbers(QString unit) : unit_(std::move(unit)) {} // of lengths; empty: not known

  /// To `digits` significant digits, without an exponent, thousands set apart: "12 340".
  [[nodiscard]] QString number(double value, int digits = 4) const;
  [[nodiscard]] QString length(double value, int digits = 4) const; // with the unit
  /// Without zeros at the end, as people give it: "10" where a measured length is "10.00".
  [[nodiscard]] QString given(double value) const;
  [[nodiscard]] QString givenLength(double value) const;
  [[nodiscard]] QString count(std::size_t count) const;
  [[nodiscard]] QString share(double value, int decimals = 3) const; // "0.785"
  [[nodiscard]] QString percent(double share) const;                 // "78.5 %"
  /// By how much `found` is above `expected`: "+12.9 %"; a dash if nothing is expected.
  [[nodiscard]] QString difference(double found, double expected) const;
  [[nodiscard]] QString range(const ScoreInterval& interval) const; // "0.771 to 0.798"
  [[nodiscard]] QString degrees(double radians) const;              // "54.2°"

  /// The name of a column of lengths, areas (power 2) or volumes (3) with their unit.
  [[nodiscard]] QString inUnit(const QString& name, int power = 1) const;

  [[nodiscard]] const QString& unit() const { return unit_; }

private:
  QString unit_;
};

} // namespace espalier
