#include "app/window/files/file_flow.h"

#include "app/window/files/file_filters.h"
#include "app/window/files/recent_files.h"
#include "app/window/frame/action_set.h"
#include "core/base/error.h"
#include "core/io/atomic_file.h"
#include "core/io/dropped.h"
#include "core/io/formats.h"
#include "core/skeleton/bounds.h"
#include "core/skeleton/edits.h"
#include "ui/document/plant_document.h"
#include "ui/document/shown_message.h"
#include "ui/jobs/job_slot.h"

#include <QAction>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>

#include <utility>

namespace espalier {
namespace {

const QString axesKey = QStringLiteral("save_mtg_with_axes");

/// Whether a skeleton saved there can be opened again.
bool canBeSavedTo(const QString& path) {
  if (path.isEmpty()) return false;
  try {
    return formatToWrite(toPath(path), Content::structure).canRead();
  } catch (const Error&) { // read from a format that is only read: another name is asked for
    return false;
  }
}

bool isProjectName(const QString& path) {
  return path.endsWith(".espalier", Qt::CaseInsensitive);
}

QString proposedPath(const PlantDocument& document, const QString& folder) {
  const QFileInfo file(document.filePath());
  if (isProjectName(document.filePath()))
    return file.path() + "/" + file.completeBaseName() + ".mtg";
  if (!document.filePath().isEmpty()) return document.filePath();
  const QFileInfo scan(document.scanPath());
  if (scan.fileName().isEmpty()) return folder + "/plant.mtg";
  return scan.path() + "/" + scan.completeBaseName() + ".mtg";
}

} // namespace

FileFlow::FileFlow(const Parts& parts) : parts_(parts), named_(namedColumns(parts.settings)) {
  parts_.projects.setGate(
      [this](const std::function<void()>& show) { showUnlessKept(show, true); });
  connect(&parts_.projects, &ProjectFlow::scanGrown, this, [this] {
    setPart({}); // the file of scans that were joined is read whole
    emit keptChanged();
  });
  addActions();
  addProjectActions();
  keepInProject({scanPartName, [this] { return textOf(part_); },
                 [this](const std::string& text) { setPart(scanPartIn(text)); }});
}

void FileFlow::setPart(const ScanPart& part) {
  part_ = part;
  parts_.actions["read_region"]->setEnabled(part_.isPart());
  emit countChanged();
}

QString FileFlow::count() const {
  if (!part_.isPart()) return {};
  return tr("part of %1").arg(formatCount(static_cast<std::size_t>(part_.listed)));
}

void FileFlow::openRegion() {
  const std::optional<Eigen::AlignedBox3d> box = parts_.clipBox();
  if (!part_.isPart()) throw Error(tr("all points of the scan are open").toStdString());
  if (!box)
    throw Error(tr("no region is chosen: clip the view to a box around it first, by Clipping in "
                   "the View menu")
                    .toStdString());
  Opening opening{.paths = {parts_.document.scanPath()},
                  .request = scanRequest(parts_.settings, box),
                  .asking = Asking::never,
                  .unit = parts_.document.unit(),
                  .up = parts_.document.up()};
  opening.request.columns = part_.reading.columns;
  read(opening);
}

void FileFlow::chooseAndOpen(Asking asking) {
  const QStringList paths =
      QFileDialog::getOpenFileNames(&parts_.window, tr("Open a scan or a skeleton"),
                                    parts_.settings.value(folderKey).toString(), readableFilters());
  if (!paths.isEmpty()) open(paths, asking);
}

void FileFlow::open(const QStringList& paths) {
  open(paths, Asking::ifUnclear);
}

void FileFlow::openPlant(const QString& path) {
  if (isProjectName(path)) return open({path});
  read({.paths = {path}, .request = scanRequest(parts_.settings), .isPlant = true});
}

void FileFlow::openWithChoices(const QStringList& paths) {
  open(paths, Asking::always);
}

void FileFlow::open(const QStringList& paths, Asking asking) {
  parts_.jobs.requireIdle();
  for (const QString& path : paths) {
    if (!isProjectName(path) && !isProject(toPath(path))) continue;
    if (paths.size() > 1) throw Error(tr("%1: open a project alone").arg(path).toStdString());
    parts_.projects.open(path);
    return;
  }
  QStringList scans;
  QStringList others;
  for (const QString& path : paths)
    (formatOf(toPath(path)).content == Content::points ? scans : others).append(path);
  openScans(scans, others, asking);
}

void FileFlow::openScans(const QStringList& scans, const QStringList& structures, Asking asking) {
  const bool areTwo = scans.size() == 2;
  const bool isAsked = parts_.document.scan() != nullptr && asking != Asking::always &&
                       scans != QStringList(parts_.document.scanPath()); // which is read again
  Opening opening{
      .paths = scans + structures, .request = scanRequest(parts_.settings), .asking = asking};
  if (scans.size() > 2 || scans.isEmpty() || (!areTwo && !isAsked)) return read(opening);
  const Second answer = areTwo ? askAboutTwo(scans.front(), scans.back()) : askAbout(scans.front());
  if (answer == Second::left) return;
  if (answer == Second::registered && !areTwo) return emit registrationAsked(scans.back());
  opening.paths = QStringList(scans.front()) + structures;
  if (answer == Second::registered) opening.toRegister = scans.back();
  read(opening);
}

void FileFlow::readOther(const QString& path, const std::function<void(LoadedFiles)>& take) {
  read({.paths = {path},
        .request = scanRequest(parts_.settings),
        .unit = parts_.document.unit(),
        .up = parts_.document.up(),
        .take = take});
}

void FileFlow::read(const Opening& opening) {
  parts_.jobs.requireIdle();
  bool hasScan = false;
  bool hasStructure = false;
  for (const QString& path : opening.paths)
    (formatOf(toPath(path)).content == Content::points ? hasScan : hasStructure) = true;
  const bool isAnotherPlant =
      hasScan && !opening.take && (opening.isPlant || parts_.document.scan() != nullptr);
  const bool isAtOnce =
      !isAnotherPlant && !hasStructure && !opening.take && opening.toRegister.isEmpty();
  const QFileInfo file(opening.paths.front());
  parts_.settings.setValue(folderKey, file.absolutePath());
  const auto* scan = parts_.document.scan();
  const auto cloud = scan == nullptr || isAnotherPlant ? nullptr : scan->cloud();
  const Skeleton skeleton = isAnotherPlant ? Skeleton() : parts_.document.skeleton();
  parts_.jobs.start(
      tr("Reading %1").arg(file.fileName()),
      [opening, cloud, skeleton, known = named_](const Progress& progress) {
        Read read = readOrAsk(opening, known, progress);
        const LoadedFiles& files = read.files;
        if (opening.take) return read;
        if (const auto& points = files.scan ? files.scan->cloud() : cloud)
          read.fit = fitOf(files.structure ? files.structure->skeleton : skeleton, *points);
        return read;
      },
      [this, opening, isAnotherPlant, isAtOnce](Read read) {
        if (isAtOnce && !read.look) return show(std::move(read), isAnotherPlant);
        const auto kept = std::make_shared<Read>(std::move(read));
        parts_.jobs.afterwards([this, opening, isAnotherPlant, kept] {
          finish(opening, std::move(*kept), isAnotherPlant);
        });
      });
}

void FileFlow::finish(const Opening& opening, Read read, bool isAnotherPlant) {
  if (read.look) return ask(opening, *read.look);
  if (opening.take) return opening.take(std::move(read.files));
  showUnlessKept(
      [&] {
        show(std::move(read), isAnotherPlant);
        if (!opening.toRegister.isEmpty()) emit registrationAsked(opening.toRegister);
      },
      isAnotherPlant);
}

bool FileFlow::save() {
  if (parts_.projects.isNamed()) return parts_.projects.confirmSaved();
  const QString path = parts_.document.filePath();
  if (!canBeSavedTo(path)) return saveAs();
  writeTo({path, path == saved_.path ? saved_.style : preferredStyle()});
  return true;
}

bool FileFlow::saveAs() {
  const Target target = chooseTarget(tr("Save the skeleton"));
  if (target.path.isEmpty()) return false;
  writeTo(target);
  return parts_.projects.isNamed() || !parts_.document.isModified();
}

void FileFlow::exportStructure() {
  const Target target = chooseTarget(tr("Export the structure"));
  if (target.path.isEmpty()) return;
  write(target, tr("Exported %1"));
}

MtgStyle FileFlow::preferredStyle() const {
  return parts_.settings.value(axesKey).toBool() ? MtgStyle::plantAxisNode : MtgStyle::plantNode;
}

FileFlow::Target FileFlow::chooseTarget(const QString& title) {
  const QString folder = parts_.settings.value(folderKey).toString();
  const bool hasOwnScales = hasScales(parts_.document.structure());
  QFileDialog dialog(&parts_.window, title);
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  const QStringList filters = writableFilters(hasOwnScales);
  dialog.setNameFilters(filters);
  dialog.setDefaultSuffix("mtg");
  const QFileInfo proposed(proposedPath(parts_.document, folder));
  dialog.setDirectory(proposed.absolutePath());
  dialog.selectFile(proposed.fileName());
  QString filter = filterFor(proposed.fileName(), filters);
  if (filter == filterOf(MtgStyle::plantNode)) filter = filterOf(preferredStyle());
  dialog.selectNameFilter(filter);
  connect(&dialog, &QFileDialog::filterSelected, &dialog,
          [&dialog, before = filter](const QString& chosen) mutable {
            const QString name = dialog.selectedFiles().value(0);
            dialog.selectFile(withExtensionOf(chosen, name, std::exchange(before, chosen)));
          });
  if (dialog.exec() != QDialog::Accepted) return {};
  Target target{dialog.selectedFiles().front(), preferredStyle()};
  for (const MtgStyle style : {MtgStyle::plantNode, MtgStyle::plantAxisNode})
    if (dialog.selectedNameFilter() == filterOf(style)) target.style = style;
  target.format = &formatChosen(dialog.selectedNameFilter(), target.path);
  parts_.settings.setValue(axesKey, target.style == MtgStyle::plantAxisNode);
  return target;
}

bool FileFlow::mayClose() {
  if (!mayDiscard()) return false;
  parts_.jobs.cancel();
  parts_.projects.leave();
  return true;
}

void FileFlow::closePlant() {
  if (parts_.jobs.isBusy()) parts_.jobs.cancel();
  if (!parts_.mayLeaveScan() || !mayDiscard()) return;
  parts_.projects.clear();
  emit outdated();
  parts_.projects.offerSessions();
  emit closed();
}

bool FileFlow::mayDiscard() {
  const bool isNamed = parts_.projects.isNamed();
  if (parts_.projects.keepsWork() || (!isNamed && !parts_.document.isModified())) return true;
  QMessageBox box(QMessageBox::NoIcon, tr("Unsaved edits"),
                  tr("<b>Save the edits to this skeleton?</b>"), QMessageBox::NoButton,
                  &parts_.window);
  const QString path = parts_.document.filePath();
  const QStringList dropped =
      isNamed || !canBeSavedTo(path)
          ? QStringList()
          : droppedBySavingAs(formatToWrite(toPath(path), Content::structure));
  box.setInformativeText((QStringList(tr("They are lost otherwise")) + dropped).join(".\n") + ".");
  QPushButton* save = box.addButton(tr("Save"), QMessageBox::AcceptRole);
  QPushButton* project =
      dropped.isEmpty() ? nullptr : box.addButton(tr("Save Project As…"), QMessageBox::AcceptRole);
  QPushButton* discard = box.addButton(tr("Discard"), QMessageBox::DestructiveRole);
  QPushButton* keep = box.addButton(tr("Keep editing"), QMessageBox::RejectRole);
  box.setDefaultButton(project != nullptr ? project : save); // which loses nothing
  box.setEscapeButton(keep);
  box.exec();
  if (box.clickedButton() == save && !isNamed) return this->save();
  if (box.clickedButton() == save || (project != nullptr && box.clickedButton() == project))
    return parts_.projects.saveAs() && parts_.projects.keepsWork();
  return box.clickedButton() == discard;
}

void FileFlow::showUnlessKept(const std::function<void()>& show, bool isAnotherPlant) {
  try {
    if ((!isAnotherPlant || parts_.mayLeaveScan()) && mayDiscard()) show();
  } catch (const Error& error) { // they were to be saved and could not be
    emit reported({.text = shownText(error), .isError = true});
  }
}

void FileFlow::show(Read read, bool isAnotherPlant) {
  LoadedFiles& loaded = read.files;
  PlantDocument& document = parts_.document;
  if (isAnotherPlant)
    parts_.projects.clear();
  else if (loaded.structure)
    parts_.projects.leave();
  if (loaded.scan) {
    document.setUnit(read.unit.value_or(loaded.unit));
    document.setScan(std::move(loaded.scan), loaded.scanPath);
    if (read.up) document.setUp(*read.up);
    parts_.projects.setScanReference(loaded.scanReference);
    setPart(loaded.part);
    emit keptChanged();
    parts_.recent.add(loaded.scanPath);
  }
  if (loaded.structure) {
    if (document.scan() == nullptr)
      document.setUnit(likelyUnit(bounds(loaded.structure->skeleton)));
    document.openStructure(std::move(*loaded.structure), loaded.structurePath);
    parts_.recent.add(loaded.structurePath);
    copied_.clear();
  }
  emit opened();
  if (!reportFit(read.fit, std::move(loaded.notes))) parts_.projects.offerSessions();
}

bool FileFlow::reportFit(const ScanFit& fit, QStringList notes) {
  PlantDocument& document = parts_.document;
  const QString file = QFileInfo(document.filePath()).fileName();
  const QString structure = file.isEmpty() ? tr("the skeleton") : file;
  if (fit.shift) {
    notes.append(offerToMove(structure, *fit.shift, document.unit()));
    const auto move = [this, shift = *fit.shift] {
      parts_.jobs.requireIdle();
      parts_.document.edit(tr("Move structure onto the scan"),
                           [&](SkeletonEditor& editor) { moveAll(editor, shift); });
      emit movedOntoScan();
    };
    emit reported({.text = notes.join('\n'), .actions = {{tr("Move"), move}}});
    return true;
  }
  if (fit.misfit)
    notes.append(describe(*fit.misfit, structure, QFileInfo(document.scanPath()).fileName()));
  if (notes.isEmpty()) return false;
  std::vector<BannerAction> actions;
  if (part_.isPart())
    actions.push_back(
        {tr("Read the Region in Full"), [this] { parts_.actions["read_region"]->trigger(); }});
  emit reported({.text = notes.join('\n'), .actions = std::move(actions)});
  return true;
}

void FileFlow::write(const Target& target, const QString& note) {
  const auto path = toPath(target.path);
  removeLeftovers(placeOf(path).parent_path());
  const Format& format =
      target.format != nullptr ? *target.format : formatToWrite(path, Content::structure);
  writeStructure(path, parts_.document.structure(), format, target.style);
  emit outdated(); // of what kept it from being saved before
  emit noted(note.arg(QFileInfo(target.path).fileName()));
  const QStringList dropped = droppedBySavingAs(format);
  if (!dropped.isEmpty()) emit reported({.text = dropped.join('\n')});
}

void FileFlow::writeTo(const Target& target) {
  const QString& path = target.path;
  // A file of others may hold more than a skeleton: what it held before is kept once, beside it.
  const bool isOfOthers = path == parts_.document.filePath() && path != copied_;
  if (isOfOthers && QFileInfo(path).isFile()) {
    std::error_code ignored; // the folder may allow no second file; saving is what was asked for
    std::filesystem::copy_file(toPath(path), toPath(path + "~"),
                               std::filesystem::copy_options::overwrite_existing, ignored);
  }
  write(target, tr("Saved %1"));
  saved_ = target;
  if (!canBeSavedTo(path))
    return; // lines or a table, as other programs want: the plant is not kept
  copied_ = path;
  if (!parts_.projects.isNamed() && !parts_.document.isReadOnly()) parts_.document.markSaved(path);
  parts_.recent.add(path);
}

QStringList FileFlow::droppedBySavingAs(const Format& format) const {
  QStringList sentences;
  for (const ShownMessage& sentence : droppedBy(format, parts_.document.structure())) {
    QString text = shownText(sentence);
    text[0] = text[0].toUpper(); // "node list keeps no ..."
    sentences.append(text);
  }
  return sentences;
}

} // namespace espalier
