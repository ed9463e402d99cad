#include "ui/panels/worklist_model.h"

#include "core/base/printable.h"
#include "ui/document/hand_work_text.h"
#include "ui/document/length_unit.h"
#include "ui/document/seal_text.h"
#include "ui/document/shown_message.h"

#include <QCoreApplication>
#include <QFont>
#include <QIcon>
#include <QPixmap>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <set>

namespace espalier {
namespace {

constexpr std::int64_t oneMinute = 60'000; // [ms]

struct WorklistText {
  Q_DECLARE_TR_FUNCTIONS(Worklist)
};

QString textOfPath(const std::filesystem::path& path) {
  return QString::fromStdString(path.string());
}

/// On one line, and not too long to be laid out at once.
QString cellOf(const std::string& text) {
  constexpr qsizetype most = 200; // letters, of at most four bytes each
  const QString line = QString::fromStdString(printable(text.substr(0, 4 * most)));
  return line.size() > most ? line.left(most) + QStringLiteral("…") : line;
}

/// What is wrong with a file or a line, in a row that says which: without its name.
QString problemText(const WorklistRow& row) {
  ShownMessage problem = *row.problem;
  const bool isLine = row.file().empty() && !row.named.empty(); // the row has what that names
  if (isLine) problem.where.reset();
  QString text = cellOf(shownText(problem).toStdString());
  const QString name = textOfPath(row.file().filename());
  const bool isNamed = !name.isEmpty() && text.startsWith(name);
  if (!isLine && !isNamed) return text; // it begins with another
  const auto isBetween = [](QChar sign) { return sign.isSpace() || sign == ':'; };
  if (isNamed)
    text.erase(text.cbegin(),
               std::find_if_not(text.cbegin() + name.size(), text.cend(), isBetween));
  if (!text.isEmpty()) text[0] = text[0].toUpper();
  return text;
}

/// The last `count` folders of a path.
std::filesystem::path endOf(const std::filesystem::path& folder, std::ptrdiff_t count) {
  std::filesystem::path end;
  auto part = folder.end();
  for (std::ptrdiff_t i = std::min(count, std::distance(folder.begin(), folder.end())); i > 0; --i)
    --part;
  for (; part != folder.end(); ++part)
    end /= *part;
  return end;
}

/// Of files that have one name, in what they differ: the shortest ends of their folders.
std::vector<std::filesystem::path> apartBy(const std::vector<std::filesystem::path>& files) {
  const auto ends = [&](std::ptrdiff_t count) {
    std::vector<std::filesystem::path> all;
    all.reserve(files.size());
    for (const std::filesystem::path& file : files)
      all.push_back(endOf(file.parent_path(), count));
    return all;
  };
  const auto kinds = [](const std::vector<std::filesystem::path>& all) {
    return std::set(all.begin(), all.end()).size();
  };
  constexpr std::ptrdiff_t whole = std::numeric_limits<std::ptrdiff_t>::max();
  const std::size_t folders = kinds(ends(whole));
  if (folders == 1) return {};
  std::ptrdiff_t count = 1;
  while (kinds(ends(count)) < folders)
    ++count;
  return ends(count);
}

/// "plot.ply", or "plot.ply · north" where there is another plot.ply.
QStringList namesOf(const std::vector<ListedPlant>& plants) {
  std::map<std::filesystem::path, std::vector<std::size_t>> byName;
  QStringList names;
  for (std::size_t i = 0; i < plants.size(); ++i) {
    const std::filesystem::path name = plants[i].row.file().filename();
    byName[name].push_back(i);
    names.append(cellOf(name.empty() ? plants[i].row.named : name.string()));
  }
  for (const auto& [name, same] : byName) {
    if (same.size() == 1 || name.empty()) continue;
    std::vector<std::filesystem::path> files;
    for (const std::size_t i : same)
      files.push_back(plants[i].row.file());
    const std::vector<std::filesystem::path> folders = apartBy(files);
    for (std::size_t i = 0; i < folders.size(); ++i)
      names[static_cast<qsizetype>(same[i])] += " · " + cellOf(folders[i].string());
  }
  return names;
}

/// Where there is nothing to show.
QString none() {
  return QStringLiteral("–");
}

QChar stageOf(const WorklistRow& row) {
  const QString letters = WorklistModel::stages();
  if (row.problem) return letters[4];
  return row.isRead ? letters[static_cast<int>(row.stage())] : letters[5];
}

/// "F 0.93 within 0.012, T 0.88 with Ben", the distance in the units of the scan
QString agreementText(const SealedAgreement& agreement) {
  QString text = WorklistText::tr("F %1 within %2")
                     .arg(QString::number(agreement.f, 'f', 2),
                          formatLength(agreement.distance, LengthUnit::unknown, 3));
  if (agreement.structural)
    text += WorklistText::tr(", T %1").arg(*agreement.structural, 0, 'f', 2);
  return WorklistText::tr("%1 with %2").arg(text, QString::fromStdString(agreement.with));
}

/// Empty where there is none, so that all names begin at one place.
QIcon iconOf(const QImage& picture) {
  if (!picture.isNull()) return QPixmap::fromImage(picture);
  QPixmap empty(96, 96);
  empty.fill(Qt::transparent);
  return empty;
}

QVariant alignmentOf(int column) {
  const bool isNumber = column == WorklistModel::findingsColumn ||
                        column == WorklistModel::minutesColumn ||
                        column == WorklistModel::agreementColumn;
  // Numbers stand apart from the names beside them.
  return QVariant((isNumber ? Qt::AlignHCenter : Qt::AlignLeft) | Qt::AlignVCenter);
}

/// All that a row has to say, for its tip.
QString wholeText(const ListedPlant& plant) {
  const WorklistRow& row = plant.row;
  QStringList lines = {QString::fromStdString(printable(row.file().string()))};
  if (row.problem)
    lines.append(row.file().empty() ? cellOf(shownText(*row.problem).toStdString())
                                    : stateText(row)); // of a line, which one it is
  if (row.state && row.state->seal)
    lines.append((plant.isFinished() ? WorklistText::tr("Signed by %1")
                                     : WorklistText::tr("Edited since it was signed by %1"))
                     .arg(signatureOf(*row.state->seal)));
  if (row.state && row.state->nodes > 0) {
    lines.append(row.state->nodes == 1
                     ? WorklistText::tr("1 node")
                     : WorklistText::tr("%1 nodes").arg(formatCount(row.state->nodes)));
    lines.append(WorklistText::tr("At work: %1").arg(formatWorkTime(row.state->time)));
  }
  if (plant.agreement)
    lines.append(WorklistText::tr("Agreement: %1").arg(agreementText(*plant.agreement)));
  lines.removeAll(QString());
  return lines.join('\n');
}

} // namespace

QString stateText(const WorklistRow& row) {
  if (row.problem) return problemText(row);
  if (!row.isRead) return WorklistText::tr("Reading…");
  switch (row.stage()) {
  case WorkStage::toDo:
    return WorklistText::tr("To do");
  case WorkStage::automatic:
    return WorklistText::tr("Automatic");
  case WorkStage::inReview:
    return row.state->seal ? WorklistText::tr("In review, seal broken")
                           : WorklistText::tr("In review");
  case WorkStage::finished:
    return WorklistText::tr("Signed by %1").arg(cellOf(row.state->seal->author));
  }
  return {};
}

QString ListedPlant::file() const {
  return textOfPath(row.file());
}

WorklistModel::WorklistModel(QObject* parent) : QAbstractTableModel(parent) {}

void WorklistModel::show(std::vector<ListedPlant> plants, const QStringList& others) {
  const auto fileOf = [](const ListedPlant& plant) { return plant.row.file(); };
  const bool areSame = others == others_ && std::ranges::equal(plants, plants_, {}, fileOf, fileOf);
  if (!areSame) beginResetModel();
  plants_ = std::move(plants);
  names_ = namesOf(plants_);
  others_ = others;
  if (!areSame) return endResetModel();
  if (!plants_.empty()) emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
}

void WorklistModel::setOpen(const QString& file) {
  if (open_ == file) return;
  open_ = file;
  if (!plants_.empty()) emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
}

int WorklistModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(plants_.size());
}

int WorklistModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : columns + static_cast<int>(others_.size());
}

QVariant WorklistModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {}; // Ctrl+C where no row is current
  const ListedPlant& plant = plants_[static_cast<std::size_t>(index.row())];
  const int column = index.column();
  switch (role) {
  case Qt::DisplayRole:
    return textOf(plant, column);
  case sortRole:
    return sortKeyOf(plant, column);
  case stageRole:
    return QString(stageOf(plant.row));
  case Qt::DecorationRole:
    return column == plantColumn ? QVariant(iconOf(plant.picture)) : QVariant();
  case Qt::ToolTipRole:
    return wholeText(plant);
  case Qt::FontRole: {
    QFont font;
    font.setBold(!open_.isEmpty() && plant.file() == open_);
    return font;
  }
  case Qt::TextAlignmentRole:
    return alignmentOf(column);
  default:
    return {};
  }
}

QVariant WorklistModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole) return alignmentOf(section);
  const bool isTip = role == Qt::ToolTipRole;
  if (role != Qt::DisplayRole && !isTip) return {};
  switch (section) {
  case plantColumn:
    return tr("Plant");
  case stateColumn:
    return tr("State");
  case findingsColumn:
    return isTip ? tr("Findings of the checks, without doubts, that were open when the plant was "
                      "signed, or last checked")
                 : tr("Findings");
  case minutesColumn:
    return isTip ? tr("Minutes at work by hand; pauses of over 5 minutes do not count")
                 : tr("Minutes");
  case annotatorColumn:
    return tr("Annotator");
  case secondColumn:
    return isTip ? tr("Who else works on the same scan, or whose structure the seal names")
                 : tr("Second annotator");
  case agreementColumn:
    return isTip ? tr("F of both structures; the tip of a row says within which distance")
                 : tr("Agreement");
  default:
    return cellOf(others_.value(section - columns).toStdString());
  }
}

QString WorklistModel::textOf(const ListedPlant& plant, int column) const {
  const WorklistRow& row = plant.row;
  const auto orNone = [](const std::string& text) { return text.empty() ? none() : cellOf(text); };
  switch (column) {
  case plantColumn: {
    const QString& name = names_[&plant - plants_.data()];
    return name.isEmpty() ? none() : name;
  }
  case stateColumn:
    return stateText(row);
  case findingsColumn:
    return row.state && row.state->openFindings ? formatCount(*row.state->openFindings) : none();
  case minutesColumn: {
    if (!row.state || row.state->time == 0) return none();
    const auto minutes = static_cast<std::size_t>(row.state->time / oneMinute); // as the seal
    return minutes == 0 ? tr("under 1") : formatCount(minutes);
  }
  case annotatorColumn:
    return orNone(row.annotator);
  case secondColumn:
    return row.second.empty() && plant.agreement ? orNone(plant.agreement->with)
                                                 : orNone(row.second);
  case agreementColumn:
    if (!plant.isCompared) return QStringLiteral("…");
    return plant.agreement ? QString::number(plant.agreement->f, 'f', 2) : none();
  default: {
    const auto i = static_cast<std::size_t>(column - columns);
    return i < row.others.size() ? cellOf(row.others[i]) : QString();
  }
  }
}

QVariant WorklistModel::sortKeyOf(const ListedPlant& plant, int column) const {
  const WorklistRow& row = plant.row;
  switch (column) {
  case stateColumn:
    return static_cast<int>(stages().indexOf(stageOf(row)));
  case findingsColumn:
    return row.state && row.state->openFindings ? static_cast<qlonglong>(*row.state->openFindings)
                                                : qlonglong{-1};
  case minutesColumn:
    return row.state ? static_cast<qlonglong>(row.state->time) : qlonglong{-1};
  case agreementColumn:
    return plant.agreement ? plant.agreement->f : -1.0;
  default: {
    const QString text = textOf(plant, column);
    bool isNumber = false; // of a further column
    const double number = text.toDouble(&isNumber);
    return column >= columns && isNumber ? QVariant(number) : QVariant(text);
  }
  }
}

} // namespace espalier
