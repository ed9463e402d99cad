#pragma once

#include "core/worklist/worklist.h"

#include <QAbstractTableModel>
#include <QImage>
#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

namespace espalier {

/// A row of a worklist, with what the window has found of it.
struct ListedPlant {
  WorklistRow row;
  QImage picture = {};                           // null: not made yet
  std::optional<SealedAgreement> agreement = {}; // with the second annotator
  bool isCompared = true;                        // false: it is being compared

  [[nodiscard]] QString file() const; // to open; empty: none
  [[nodiscard]] bool isFinished() const { return row.stage() == WorkStage::finished; }
};

/// The plants of a worklist: what each is, how far the work on it has come, and who does it. Where
/// names repeat, what the folders differ in is shown, too; of long texts, the beginning.
class WorklistModel : public QAbstractTableModel {
  Q_OBJECT

public:
  enum Column {
    plantColumn,
    stateColumn,
    findingsColumn,
    minutesColumn,
    annotatorColumn,
    secondColumn,
    agreementColumn,
    columns // further ones of a table follow
  };
  enum Role {
    sortRole = Qt::UserRole,
    stageRole // the letter of the stage, as in stages()
  };
  /// A letter for each stage, by WorkStage; then that of a row with a problem, and of one that is
  /// not read yet.
  [[nodiscard]] static QString stages() { return QStringLiteral("tarspu"); }

  explicit WorklistModel(QObject* parent = nullptr);

  void show(std::vector<ListedPlant> plants, const QStringList& others);
  /// Marks the plant that is open; empty: none of them is.
  void setOpen(const QString& file);
  [[nodiscard]] const std::vector<ListedPlant>& plants() const { return plants_; }

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                    int role) const override;

private:
  [[nodiscard]] QString textOf(const ListedPlant& plant, int column) const;
  [[nodiscard]] QVariant sortKeyOf(const ListedPlant& plant, int column) const;

  std::vector<ListedPlant> plants_;
  QStringList names_; // of these, as shown
  QStringList others_;
  QString open_;
};

/// "To do", "Automatic", "In review", "Signed by Anna", or why it cannot be read.
[[nodiscard]] QString stateText(const WorklistRow& row);

} // namespace espalier
