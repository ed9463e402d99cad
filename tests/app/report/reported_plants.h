#pragma once

#include "app/report/comparison_report.h"
#include "core/evaluate/comparison_options.h"
#include "tests/support/plants.h"

#include <QRegularExpression>
#include <QStringList>

namespace espalier::test {

/// A trunk of 2 and a branch of 1 that leaves its middle to the side; nodes every tenth.
inline Skeleton branched() {
  Skeleton plant = stick(21, 0.1);
  NodeId last{10};
  for (int i = 1; i <= 10; ++i)
    last = plant.add({.position = {0.1 * i, 0, 1},
                      .radius = 0.05,
                      .parent = last,
                      .edge = i == 1 ? EdgeType::branching : EdgeType::successor});
  return plant;
}

/// The report's data of two plants that are compared where they lie.
inline ReportData reported(const Skeleton& result, const Skeleton& reference,
                           double tolerance = 0) {
  ComparisonOptions options;
  options.registers = false;
  return reportData(compare(result, reference, withTolerance(options, reference, tolerance)),
                    result, reference, nullptr, tolerance);
}

inline ReportAbout aboutPlants() {
  ReportAbout about;
  about.result = {"oak.mtg", QString(64, 'a')};
  about.reference = {"expert.mtg", QString(64, 'b')};
  about.date = "2026-01-02";
  about.version = "9.8.7";
  about.unit = "m";
  return about;
}

/// All that a section says in words.
inline QString textOf(const ReportSection& section) {
  QStringList texts = {section.title};
  for (const ReportBlock& block : section.blocks) {
    if (const auto* paragraph = std::get_if<ReportParagraph>(&block)) texts << paragraph->text;
    if (const auto* warnings = std::get_if<ReportWarnings>(&block)) texts << warnings->lines;
    if (const auto* legend = std::get_if<ReportLegend>(&block))
      for (const auto& entry : legend->entries)
        texts << entry.name + ": " + entry.text;
  }
  return texts.join('\n');
}

inline const ReportSection& sectionOf(const Report& report, const QString& title) {
  for (const ReportSection& section : report.sections)
    if (section.title == title) return section;
  throw std::out_of_range(title.toStdString());
}

/// The cell of a row that begins with a name, among the tables of a section; empty: there is none.
inline QString cellOf(const ReportSection& section, const QString& row, std::size_t column) {
  for (const ReportBlock& block : section.blocks)
    if (const auto* table = std::get_if<ReportTable>(&block))
      for (const auto& cells : table->rows)
        if (cells.front().text == row && column < cells.size()) return cells[column].text;
  return {};
}

inline int pagesOf(const QByteArray& pdf) {
  static const QRegularExpression page("/Type\\s*/Page\\b(?!s)");
  return static_cast<int>(QString::fromLatin1(pdf).count(page));
}

} // namespace espalier::test
