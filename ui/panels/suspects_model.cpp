#include "ui/panels/suspects_model.h"

#include "ui/document/number_scale.h"

#include <utility>

namespace espalier {
namespace {

enum SuspectColumn { suspectPlace, suspectGain, suspectColumns };

/// "0.042 %"
QString gainText(double share) {
  const double percent = 100 * share;
  const int decimals = percent < 0.1 ? 3 : percent < 1 ? 2 : 1;
  return SuspectsModel::tr("%1 %").arg(numberText(percent, decimals));
}

} // namespace

SuspectsModel::SuspectsModel(TextOf textOf, QObject* parent)
    : QAbstractTableModel(parent), textOf_(std::move(textOf)) {}

void SuspectsModel::show(std::vector<Suspect> suspects) {
  if (suspects.size() == suspects_.size()) { // where one is in the list stays
    suspects_ = std::move(suspects);
    if (!suspects_.empty()) emit dataChanged(index(0, 0), index(rowCount() - 1, suspectGain));
    return;
  }
  beginResetModel();
  suspects_ = std::move(suspects);
  endResetModel();
}

int SuspectsModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(suspects_.size());
}

int SuspectsModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : suspectColumns;
}

QVariant SuspectsModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {}; // Ctrl+C where no row is current
  const Suspect& suspect = suspects_[static_cast<std::size_t>(index.row())];
  const bool isGain = index.column() == suspectGain;
  switch (role) {
  case Qt::TextAlignmentRole:
    return QVariant((isGain ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  case Qt::DisplayRole: {
    const SuspectText text = textOf_(suspect);
    return isGain ? gainText(suspect.gain) + '\n' + text.remedy : text.title + '\n' + text.place;
  }
  case Qt::ToolTipRole:
  case Qt::AccessibleDescriptionRole:
    return textOf_(suspect).whole;
  default:
    return {};
  }
}

QVariant SuspectsModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole)
    return QVariant((section == suspectGain ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  if (role == Qt::ToolTipRole)
    return section == suspectGain
               ? tr("How much of the plant, of its length and its ends, a look there probably puts "
                    "right; below, the key of what helps")
               : tr("What may be wrong, at which node, and how long, thick, sharp or large it is");
  if (role != Qt::DisplayRole) return {};
  return section == suspectGain ? tr("Gain") : tr("What, at node");
}

} // namespace espalier
