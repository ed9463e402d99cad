#include "ui/panels/node_filter.h"

#include "core/base/error.h"
#include "ui/document/typed_number.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>

#include <algorithm>
#include <optional>

namespace espalier {
namespace {

struct NodeFilterText {
  Q_DECLARE_TR_FUNCTIONS(NodeTable)
};

/// By its name in a file or in the window.
std::optional<NodeColumn> columnNamed(const QString& name) {
  for (int i = 0; i < nodeColumns; ++i) {
    const auto column = static_cast<NodeColumn>(i);
    if (name.compare(keyOf(column), Qt::CaseInsensitive) == 0 ||
        name.compare(nameOf(column), Qt::CaseInsensitive) == 0)
      return column;
  }
  return std::nullopt;
}

NodeColumn requireColumn(const QString& name) {
  if (const auto column = columnNamed(name)) return *column;
  QStringList all;
  for (int i = 0; i < nodeColumns; ++i)
    all.append(keyOf(static_cast<NodeColumn>(i)));
  throw Error(NodeFilterText::tr("there is no column “%1”: the columns are %2")
                  .arg(name, all.join(QStringLiteral(", ")))
                  .toStdString());
}

bool isSame(const QString& a, const QString& b) {
  return a.compare(b, Qt::CaseInsensitive) == 0;
}

} // namespace

NodeFilter::NodeFilter(const QString& text) {
  // A comma between digits is one of a number.
  const QRegularExpression parting(
      QStringLiteral("\\s+(?:and|%1)\\s+|,(?!\\d)|(?<!\\d),")
          .arg(QRegularExpression::escape(NodeFilterText::tr("and", "between two conditions"))),
      QRegularExpression::CaseInsensitiveOption);
  for (const QString& part : text.split(parting))
    if (!part.trimmed().isEmpty()) conditions_.push_back(conditionOf(part.trimmed()));
}

bool NodeFilter::accepts(const NodeFacts& facts, NodeId id) const {
  return std::ranges::all_of(
      conditions_, [&](const Condition& condition) { return meets(condition, facts, id); });
}

NodeFilter::Condition NodeFilter::conditionOf(const QString& text) {
  static const QRegularExpression form(QStringLiteral("^([^<>=!]+?)\\s*(!=|<=|>=|=|<|>)\\s*(.*)$"));
  const QRegularExpressionMatch match = form.match(text);
  if (!match.hasMatch()) return {.text = text};
  Condition condition{.column = requireColumn(match.captured(1))};
  const QStringList signs = {"=", "!=", "<", "<=", ">", ">="};
  condition.comparison = static_cast<Comparison>(signs.indexOf(match.captured(2)));
  condition.text = match.captured(3);
  if (isNumber(condition.column)) {
    const std::optional<double> number = typedNumber(condition.text);
    if (!number)
      throw Error(NodeFilterText::tr("%1 is compared with a number, as in “%1 > 10”")
                      .arg(keyOf(condition.column))
                      .toStdString());
    condition.number = *number;
  } else if (condition.comparison > Comparison::unequal) {
    throw Error(NodeFilterText::tr("%1 is a text: compare it by = or !=")
                    .arg(keyOf(condition.column))
                    .toStdString());
  }
  return condition;
}

bool NodeFilter::meets(const Condition& condition, const NodeFacts& facts, NodeId id) {
  if (condition.comparison == Comparison::contains) {
    const QString unit = facts.text(id, NodeColumn::unit) + facts.text(id, NodeColumn::index);
    if (facts.text(id, NodeColumn::node) == condition.text) return true;
    return std::ranges::any_of(
        QStringList{unit, facts.text(id, NodeColumn::mark), facts.text(id, NodeColumn::review),
                    facts.text(id, NodeColumn::comment)},
        [&](const QString& text) { return text.contains(condition.text, Qt::CaseInsensitive); });
  }
  if (!isNumber(condition.column)) {
    const bool isEqual = isSame(facts.text(id, condition.column), condition.text);
    return isEqual == (condition.comparison == Comparison::equal);
  }
  const std::optional<double> value = facts.number(id, condition.column);
  if (!value) return condition.comparison == Comparison::unequal;
  switch (condition.comparison) {
  case Comparison::equal:
    return *value == condition.number;
  case Comparison::unequal:
    return *value != condition.number;
  case Comparison::less:
    return *value < condition.number;
  case Comparison::atMost:
    return *value <= condition.number;
  case Comparison::more:
    return *value > condition.number;
  default:
    return *value >= condition.number;
  }
}

} // namespace espalier
