#pragma once

#include "ui/plots/tolerance_plot.h"

#include <QColor>
#include <QImage>
#include <QPainter>
#include <QSize>
#include <QString>
#include <QStringList>

#include <functional>
#include <optional>
#include <variant>
#include <vector>

namespace espalier {

// What a report says, in the order in which it says it. The writers of HTML and PDF read this and
// add nothing: so both say the same.

struct ReportParagraph {
  enum class Look {
    plain,
    note, // how to read what stands above
    code  // to be typed
  };
  QString text;
  Look look = Look::plain;
};

/// What the reader has to know before trusting the numbers, a line each.
struct ReportWarnings {
  QStringList lines;
};

/// The few numbers that stand out.
struct ReportKeyNumbers {
  struct Number {
    QString value;
    QString name;
    QString help; // one line under it; may be empty
  };
  std::vector<Number> numbers;
};

struct ReportLegend {
  struct Entry {
    QString name;
    QColor color;
    QString text; // what there is of it
  };
  std::vector<Entry> entries;
};

struct ReportCell {
  QString text;
  std::optional<double> bar = {}; // in [0, 1]: a bar this long stands beside the text
};

struct ReportTable {
  struct Column {
    QString title;
    bool isNumber = true; // to the right
  };
  QString caption; // may be empty
  std::vector<Column> columns;
  std::vector<std::vector<ReportCell>> rows; // a cell per column each
};

struct ReportFigures {
  struct Figure {
    QImage image;
    QString title; // one line
    QString text;  // what it shows, for captions and for those who do not see it
  };
  int across = 2; // beside each other where there is room, >= 1
  std::vector<Figure> figures;
};

/// Painted by each writer in its own way: as lines, not as pixels.
struct ReportPlot {
  QSize size; // [CSS pixels]
  QString text;
  std::function<void(QPainter&, const QRectF&, const PlotColors&)> paint;
};

/// Words explained, each with where it is from.
struct ReportTerms {
  struct Term {
    QString name;
    QString text;
    QString source; // may be empty
  };
  std::vector<Term> terms;
};

using ReportBlock = std::variant<ReportParagraph, ReportWarnings, ReportKeyNumbers, ReportLegend,
                                 ReportTable, ReportFigures, ReportPlot, ReportTerms>;

struct ReportSection {
  QString title;
  std::vector<ReportBlock> blocks;
};

struct Report {
  QString title;
  QStringList facts; // under the title: when, by which version
  std::vector<ReportSection> sections;
};

} // namespace espalier
