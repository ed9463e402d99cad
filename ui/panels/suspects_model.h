#pragma once

#include <QAbstractTableModel>
#include <QString>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace espalier {

/// A place where the plant may be wrong: a finding of the checks, or a doubt.
struct Suspect {
  enum class Sort : std::uint8_t { finding, doubt, ignoredFinding, ignoredDoubt };
  Sort sort = Sort::finding;
  std::size_t number = 0; // in the list of its sort
  int kind = 0;           // of Finding::Kind; behind these, of Doubt::Kind
  double length = 0;      // [L] of the wood that it is about, or that is missing
  double wrong = 0;       // how probably that is an error
  double gain = 0;        // how much of the plant a look probably puts right: in [0, 1]
  /// The finding and the doubt about the same points, each with the number of the other: among all
  /// kinds, the doubt alone is listed.
  std::optional<std::size_t> twin = {};

  [[nodiscard]] bool isDoubt() const { return sort == Sort::doubt || sort == Sort::ignoredDoubt; }
  [[nodiscard]] bool isIgnored() const { return sort > Sort::doubt; }
  [[nodiscard]] bool isListedAsDoubt() const { return !isDoubt() && twin.has_value(); }
};

/// How one is written.
struct SuspectText {
  QString title;  // "Sharp turn"
  QString place;  // "12 · 140°": its node, and a number
  QString remedy; // the key of what helps
  QString whole;  // all of it, as a sentence
};

/// Suspects in two lines each: what may be wrong over its place, the gain over the key of what
/// helps. What is written is asked for as it is seen.
class SuspectsModel : public QAbstractTableModel {
  Q_OBJECT

public:
  using TextOf = std::function<SuspectText(const Suspect&)>;
  SuspectsModel(TextOf textOf, QObject* parent);

  void show(std::vector<Suspect> suspects);
  [[nodiscard]] const std::vector<Suspect>& suspects() const { return suspects_; }

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                    int role) const override;

private:
  TextOf textOf_;
  std::vector<Suspect> suspects_;
};

} // namespace espalier
