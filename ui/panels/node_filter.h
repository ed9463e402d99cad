#pragma once

#include "ui/panels/node_facts.h"

#include <QString>

#include <cstdint>
#include <vector>

namespace espalier {

/// Which nodes a table lists: those that meet all conditions.
///
/// Conditions are parted by "and" or a comma. "radius > 10" compares a column, by one of
/// = != < <= > >=; a column of text knows = and != only. Any other word or words are a text that
/// the node has as its number, or has in its class and index, mark, review state or comment.
class NodeFilter {
public:
  NodeFilter() = default; // all

  /// @throws Error what is wrong with a condition
  explicit NodeFilter(const QString& text);

  [[nodiscard]] bool accepts(const NodeFacts& facts, NodeId id) const;

private:
  enum class Comparison : std::uint8_t { equal, unequal, less, atMost, more, atLeast, contains };
  struct Condition {
    Comparison comparison = Comparison::contains;
    NodeColumn column = NodeColumn::node; // not for contains
    double number = 0;                    // for a column of numbers
    QString text = {};                    // for others
  };
  [[nodiscard]] static Condition conditionOf(const QString& text);
  [[nodiscard]] static bool meets(const Condition& condition, const NodeFacts& facts, NodeId id);

  std::vector<Condition> conditions_;
};

} // namespace espalier
