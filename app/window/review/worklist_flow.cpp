#include "app/window/review/worklist_flow.h"

#include "app/window/files/file_filters.h"
#include "app/window/files/load_files.h"
#include "app/window/frame/action_set.h"
#include "core/base/error.h"
#include "ui/document/plant_document.h"
#include "ui/panels/worklist_panel.h"

#include <QAction>
#include <QFileDialog>
#include <QFileInfo>
#include <QMainWindow>
#include <QSettings>
#include <QStandardPaths>

#include <algorithm>

namespace espalier {
namespace {

const QString placeKey = QStringLiteral("worklist");

QString canonical(const QString& path) {
  const QString whole = QFileInfo(path).canonicalFilePath();
  return whole.isEmpty() ? path : whole;
}

} // namespace

WorklistFlow::WorklistFlow(const Parts& parts)
    : parts_(parts), pictures_{parts.window.settings
                                   .value("pictures_folder", QStandardPaths::writableLocation(
                                                                 QStandardPaths::CacheLocation) +
                                                                 "/worklist")
                                   .toString()},
      place_(parts.window.settings.value(placeKey).toString()) {
  addActions();
  const auto at = [this](const char* id) { return parts_.window.actions[id]; };
  panel_ = new WorklistPanel(
      {.folder = at("worklist_folder"), .table = at("worklist_table"), .next = at("next_plant")});
  dock_ = addDock(new PanelDock(
      parts_.window,
      {.id = "worklist",
       .title = tr("Worklist"),
       .text = tr("Worklist"),
       .help = tr("Shows or hides the plants of a folder or table, and how far each is"),
       .keys = QKeySequence(Qt::CTRL | Qt::Key_J),
       .manual = "files.md#a-series-of-plants"},
      {.size = 240, .isOfPlant = false}, panel_, this));
  again_.setSingleShot(true);
  again_.setInterval(2000); // [ms]
  later_.setSingleShot(true);
  later_.setInterval(100); // [ms]: rows are shown together
  connect(&again_, &QTimer::timeout, this, &WorklistFlow::survey);
  connect(&later_, &QTimer::timeout, this, &WorklistFlow::show);
  connect(dock_, &PanelDock::shown, this, [this](bool isShown) {
    if (isShown) survey();
  });
  connect(&survey_, &JobSlot::finished, this, [this] {
    if (dock_->isShown() && !place_.isEmpty()) again_.start();
  });
  connect(&read_, &JobSlot::finished, this, &WorklistFlow::readNext);
  connect(panel_, &WorklistPanel::chosen, this, [this](const QString& file) {
    parts_.window.actions.guarded(
        [&] {
          open(file);
          return true;
        },
        Refusal::inBanner);
  });
  connect(&parts_.jobs, &JobSlot::failed, this, &WorklistFlow::noteFailure);
  connect(&parts_.jobs, &JobSlot::finished, this, [this] { opening_.clear(); });
  for (auto signal : {&PlantDocument::titleChanged, &PlantDocument::scanChanged})
    connect(&parts_.document, signal, this, [this] { panel_->setOpen(openFile()); });
}

void WorklistFlow::beginWork() {
  show();
}

void WorklistFlow::addActions() {
  ActionSet& actions = parts_.window.actions;
  actions.beginSection(tr("File"));
  actions.add({.id = "worklist_folder",
               .text = tr("Worklist of a Folder…"),
               .help = tr("Lists the projects and scans of a folder, to work on one after another"),
               .menu = "file/worklist"},
              [this] { chooseFolder(); });
  actions.add({.id = "worklist_table",
               .text = tr("Worklist of a Table…"),
               .help = tr("Lists the plants that a CSV table names, to work on one after another"),
               .menu = "file/worklist"},
              [this] { chooseTable(); });
  actions.add({.id = "next_plant",
               .text = tr("Next Plant of the Worklist"),
               .help = tr("Opens the next plant of the worklist that is not signed"),
               .keys = QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_J),
               .menu = "file/worklist"},
              [this] { openNext(); });
  actions.add({.id = "compare_second",
               .text = tr("Compare With Second Annotator"),
               .help = tr("Loads what the second annotator has of the open plant as the reference, "
                          "to decide place by place"),
               .menu = "file/worklist"},
              [this] { compareWithSecond(); });
  actions.beginSection(tr("View"));
}

void WorklistFlow::chooseFolder() {
  const QString folder = QFileDialog::getExistingDirectory(
      &parts_.window.window, tr("Choose the folder of the worklist"),
      place_.isEmpty() ? parts_.window.settings.value(folderKey).toString() : place_);
  if (!folder.isEmpty()) list(folder);
}

void WorklistFlow::chooseTable() {
  const QString table = QFileDialog::getOpenFileName(
      &parts_.window.window, tr("Choose the table of the worklist"),
      place_.isEmpty() ? parts_.window.settings.value(folderKey).toString() : place_,
      tr("Tables (*.csv *.tsv *.txt)") + ";;" + tr("All files (*)"));
  if (!table.isEmpty()) list(table);
}

void WorklistFlow::list(const QString& place) {
  read_.cancel();
  place_ = place;
  parts_.window.settings.setValue(placeKey, place);
  problem_.clear();
  list_ = {};
  stamps_.clear();
  known_.clear();
  faces_.clear();
  compared_.clear();
  toRead_.clear();
  toHash_.reset();
  show();
  dock_->bringToFront();
  survey();
}

QString WorklistFlow::openFile() const {
  const PlantDocument& document = parts_.document;
  const QString file = document.filePath().endsWith(".espalier", Qt::CaseInsensitive)
                           ? document.filePath()
                           : document.scanPath();
  return file.isEmpty() ? file : canonical(file);
}

void WorklistFlow::open(const QString& file) {
  if (file.isEmpty())
    throw Error(tr("this row has no file to open: it says what is wrong").toStdString());
  if (file == openFile()) return emit noted(tr("%1 is open").arg(QFileInfo(file).fileName()));
  parts_.open(file);
  opening_ = toPath(file);
}

void WorklistFlow::noteFailure(const QString& message) {
  // One that another window works on can be opened once that is closed.
  if (opening_.empty() || !stamps_.contains(opening_) || ProjectLock::holder(opening_)) return;
  known_[opening_].problem = ShownMessage{"%1", {message.toStdString()}};
  show();
}

bool WorklistFlow::isBeingRead() {
  if (place_.isEmpty())
    throw Error(tr("there is no worklist yet: choose a folder or a table for it").toStdString());
  if (!list_.lines.empty()) return false;
  if (!problem_.isEmpty()) throw Error(problem_.toStdString());
  survey();
  return true;
}

void WorklistFlow::openNext() {
  const QString wait = tr("The worklist is being read");
  if (isBeingRead()) {
    dock_->bringToFront();
    return emit noted(wait);
  }
  if (!dock_->isShown()) dock_->bringToFront();
  const std::vector<WorklistRow> rows = panel_->following(openFile());
  const auto next = std::ranges::find_if(rows, [](const WorklistRow& row) {
    return row.project.empty() || !ProjectLock::holder(row.project);
  });
  if (next != rows.end()) return open(QString::fromStdString(next->file().string()));
  if (panel_->isReading()) return emit noted(wait);
  throw Error((rows.empty()
                   ? tr("no other plant that the worklist shows is still to be signed")
                   : tr("the plants that are still to be signed are open in other windows"))
                  .toStdString());
}

void WorklistFlow::compareWithSecond() {
  const std::filesystem::path open = toPath(openFile());
  bool isReading = isBeingRead();
  for (const WorklistRow& row : rowsOf(list_, known_)) {
    if (!open.empty() && row.project == open && !row.secondProject.empty())
      return parts_.compareWith(QString::fromStdString(row.secondProject.string()));
    isReading = isReading || !row.isRead;
  }
  if (isReading) return emit noted(tr("The worklist is being read"));
  throw Error(tr("the worklist has no project of a second annotator for the plant that is open")
                  .toStdString());
}

void WorklistFlow::survey() {
  again_.stop();
  if (place_.isEmpty() || survey_.isBusy()) return;
  survey_.start([place = toPath(place_)](const Progress&) { return surveyWorklist(place); },
                [this, place = place_](SurveyedWorklist found) {
                  if (place == place_) takeSurvey(std::move(found));
                });
}

void WorklistFlow::takeSurvey(SurveyedWorklist found) {
  problem_ = found.problem;
  if (!problem_.isEmpty()) found.list = list_; // what was shown stays
  list_ = std::move(found.list);
  if (problem_.isEmpty()) {
    for (const auto& [file, stamp] : found.stamps) {
      const auto before = stamps_.find(file);
      if (before != stamps_.end() && before->second == stamp) continue;
      toHash_.reset();
      if (const auto known = known_.find(file); known != known_.end()) known->second.hash.reset();
      if (std::ranges::find(toRead_, file) == toRead_.end()) toRead_.push_back(file);
    }
    std::erase_if(known_, [&](const auto& each) { return !found.stamps.contains(each.first); });
    std::erase_if(faces_, [&](const auto& each) { return !found.stamps.contains(each.first); });
    std::erase_if(compared_, [&](const auto& each) {
      return !found.stamps.contains(each.first.first) || !found.stamps.contains(each.first.second);
    });
    stamps_ = std::move(found.stamps);
    // What is to be done or not is known once all projects are: scans have time.
    std::stable_partition(toRead_.begin(), toRead_.end(),
                          [&](const auto& file) { return isProject(file); });
  }
  show();
  readNext();
}

void WorklistFlow::readNext() {
  if (read_.isBusy()) return;
  while (!toRead_.empty() && !stamps_.contains(toRead_.front()))
    toRead_.pop_front(); // it is gone
  const bool areProjectsRead = toRead_.empty() || !isProject(toRead_.front());
  if (areProjectsRead && startHash()) return;
  if (toRead_.empty()) {
    if (const auto pair = nextToCompare()) compare(*pair);
    return;
  }
  const std::filesystem::path file = toRead_.front();
  toRead_.pop_front();
  read_.start(
      [file, isProject = !areProjectsRead, stamp = stamps_.at(file),
       pictures = pictures_](const Progress& progress) {
        return isProject ? readProjectOf(file, stamp, pictures, progress)
                         : readScanOf(file, stamp, pictures, progress);
      },
      [this, file](ReadPlant plant) { takePlant(file, std::move(plant)); });
}

bool WorklistFlow::isProject(const std::filesystem::path& file) const {
  return std::ranges::binary_search(list_.projects, file);
}

bool WorklistFlow::startHash() {
  if (!toHash_) {
    const std::vector<std::filesystem::path> scans = scansToHash(list_, known_);
    toHash_.emplace(scans.begin(), scans.end());
  }
  if (toHash_->empty()) return false;
  const std::filesystem::path scan = toHash_->front();
  toHash_->pop_front();
  read_.start([scan](const Progress& progress) { return readHashOf(scan, progress); },
              [this, scan](KnownWork work) {
                known_[scan] = std::move(work);
                if (!later_.isActive()) later_.start();
              });
  return true;
}

void WorklistFlow::takePlant(const std::filesystem::path& file, ReadPlant plant) {
  faces_[file] = std::move(plant.picture);
  KnownWork& known = known_[file];
  plant.work.hash = known.hash; // of a scan, found before its picture
  known = std::move(plant.work);
  if (!later_.isActive()) later_.start();
}

std::optional<WorklistFlow::Pair> WorklistFlow::nextToCompare() const {
  for (const WorklistRow& row : rowsOf(list_, known_)) {
    if (row.secondProject.empty()) continue;
    const Pair pair = std::minmax(row.project, row.secondProject);
    if (comparedOf(pair) == nullptr) return pair;
  }
  return std::nullopt;
}

const WorklistFlow::Compared* WorklistFlow::comparedOf(const Pair& pair) const {
  const auto found = compared_.find(pair);
  const auto first = stamps_.find(pair.first);
  const auto second = stamps_.find(pair.second);
  const bool isOfNow = found != compared_.end() && first != stamps_.end() &&
                       second != stamps_.end() && found->second.first == first->second &&
                       found->second.second == second->second;
  return isOfNow ? &found->second : nullptr;
}

void WorklistFlow::compare(const Pair& pair) {
  const auto stampOf = [this](const std::filesystem::path& file) {
    const auto found = stamps_.find(file);
    return found == stamps_.end() ? FileStamp() : found->second;
  };
  Compared made{stampOf(pair.first), stampOf(pair.second), std::nullopt};
  read_.start(
      [pair](const Progress& progress) { return agreementOf(pair.first, pair.second, progress); },
      [this, pair, made](std::optional<SealedAgreement> agreement) mutable {
        made.agreement = std::move(agreement);
        compared_[pair] = made;
        if (!later_.isActive()) later_.start();
      });
}

ListedPlant WorklistFlow::listed(WorklistRow row) const {
  ListedPlant plant;
  for (const std::filesystem::path& file : {row.project, row.scan})
    if (const auto found = faces_.find(file); found != faces_.end() && plant.picture.isNull())
      plant.picture = found->second;
  if (!row.secondProject.empty()) {
    const Compared* compared = comparedOf(std::minmax(row.project, row.secondProject));
    plant.isCompared = compared != nullptr;
    if (compared != nullptr) plant.agreement = compared->agreement;
    if (plant.agreement) plant.agreement->with = row.second;
  } else if (row.stage() == WorkStage::finished && row.state->seal->state) {
    plant.agreement = row.state->seal->state->other;
  }
  plant.row = std::move(row);
  return plant;
}

void WorklistFlow::show() {
  std::vector<ListedPlant> plants;
  for (WorklistRow& row : rowsOf(list_, known_))
    plants.push_back(listed(std::move(row)));
  QStringList others;
  for (const std::string& name : list_.others)
    others.append(QString::fromStdString(name));
  panel_->show(place_.isEmpty() ? QString() : QFileInfo(place_).fileName(), problem_,
               std::move(plants), others, list_.isTable);
  panel_->setOpen(openFile());
}

} // namespace espalier
