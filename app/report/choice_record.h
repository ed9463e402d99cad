#pragma once

#include "app/report/report.h"

#include <QImage>
#include <QString>

#include <string>
#include <utility>
#include <vector>

namespace espalier {

/// One of the states of a plant that were looked at when options were chosen.
struct ChoiceState {
  QString name;    // "A", "Preview", or the value of a sweep
  QString options; // under its picture: choices other than usual; empty: the name says them
  QImage picture;  // may be null
  std::vector<std::pair<QString, QString>> numbers; // name with its unit, value
  bool isTaken = false;
};

/// Why options are as they are: what was compared, in pictures and numbers.
struct ChoiceRecord {
  QString title;                                     // what was compared
  QString time;                                      // when, as it is to be written
  QString seen;                                      // what the pictures show
  std::vector<std::pair<QString, QString>> meanings; // of numbers, by their name with its unit
  std::vector<ChoiceState> states;
};

/// JSON that a project keeps; pictures are in it.
[[nodiscard]] std::string writeChoices(const std::vector<ChoiceRecord>& records);

/// Reads what writeChoices() wrote.
/// @throws Error if it is something else
[[nodiscard]] std::vector<ChoiceRecord> readChoices(const std::string& text);

/// What a report shows of them. pre: there are some
[[nodiscard]] ReportSection choicesSection(const std::vector<ChoiceRecord>& records);

} // namespace espalier
