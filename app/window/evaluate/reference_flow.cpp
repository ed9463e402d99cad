#include "app/window/evaluate/reference_flow.h"

#include "app/window/evaluate/load_reference.h"
#include "app/window/files/file_filters.h"
#include "app/window/files/load_files.h"
#include "app/window/frame/action_set.h"
#include "core/base/error.h"
#include "core/base/listed.h"
#include "core/evaluate/match/comparable.h"
#include "core/evaluate/registration/registration.h"
#include "core/io/formats.h"
#include "core/project/project.h"
#include "ui/document/plant_document.h"
#include "ui/document/shown_message.h"
#include "ui/jobs/job_slot.h"
#include "ui/view/plant_view.h"

#include <QAction>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMainWindow>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <QTimer>

#include <utility>

namespace espalier {
namespace {

constexpr auto besideId = "load_reference_beside";

QString besideText(const QString& path) {
  return path.isEmpty() ? ReferenceFlow::tr("Load Reference Beside the Scan")
                        : ReferenceFlow::tr("Compare with %1").arg(QFileInfo(path).fileName());
}

bool isStructure(const QString& path) {
  try {
    return !isProject(toPath(path)) && formatOf(toPath(path)).content == Content::structure;
  } catch (const Error&) { // opening it reports why it cannot be read
    return false;
  }
}

} // namespace

ReferenceFlow::ReferenceFlow(Parts parts) : parts_(std::move(parts)) {
  addActions();
  keepInProject({.name = "reference",
                 .text = [this] { return text_; },
                 .show = [this](const std::string& text) { show(text); }});
  connect(this, &ReferenceFlow::changed, this, &ReferenceFlow::keptChanged);
  for (auto signal : {&PlantDocument::scanChanged, &PlantDocument::titleChanged})
    connect(&parts_.document, signal, this, &ReferenceFlow::refreshBeside);
  show({});
}

QString ReferenceFlow::beside() const {
  const QFileInfo scan(parts_.document.scanPath());
  if (parts_.document.scan() == nullptr || !scan.exists()) return {};
  const QString path = scan.dir().filePath(scan.completeBaseName() + ".mtg");
  const bool isOpen = QFileInfo(path) == QFileInfo(parts_.document.filePath());
  return QFileInfo::exists(path) && !isOpen ? path : QString();
}

void ReferenceFlow::refreshBeside() {
  QAction& action = *parts_.actions[besideId];
  const QString path = beside();
  action.setText(besideText(path));
  action.setVisible(!path.isEmpty() && skeleton_ == nullptr);
}

void ReferenceFlow::addActions() {
  parts_.actions.beginSection(tr("Evaluate"));
  parts_.actions.add({.id = "load_reference",
                      .text = tr("&Load Reference…"),
                      .help = tr("Loads the structure that the plant is compared with"),
                      .keys = QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_O),
                      .menu = "file/reference"},
                     [this] { choose(); });
  parts_.actions.add(
      {.id = besideId,
       .text = besideText({}),
       .help = tr("Loads the structure that has the name of the scan and lies beside "
                  "it, as that of the sample plant"),
       .menu = "file/reference"},
      [this] { load(beside()); });
  parts_.actions.add({.id = "remove_reference",
                      .text = tr("Remove Reference"),
                      .help = tr("Puts the reference away; its file stays as it is"),
                      .menu = "file/reference"},
                     [this] { remove(); });
}

void ReferenceFlow::remove() {
  const QString file = name();
  if (before_.empty()) {
    show({});
    emit noted(tr("%1 is no longer the reference").arg(file));
    return;
  }
  Reference back = std::move(before_.front());
  set(std::move(back));
  emit noted(tr("%1 is the reference again").arg(name()));
}

QString ReferenceFlow::name() const {
  return isVersion_ ? path_ : QFileInfo(path_).fileName();
}

QString ReferenceFlow::key() const {
  return isVersion_ ? "version:" + path_ : path_;
}

void ReferenceFlow::choose() {
  const QString path =
      QFileDialog::getOpenFileName(&parts_.window, tr("Load the reference"),
                                   parts_.settings.value(folderKey).toString(), structureFilters());
  if (!path.isEmpty()) load(path);
}

void ReferenceFlow::load(const QString& path) {
  parts_.jobs.requireIdle();
  parts_.settings.setValue(folderKey, QFileInfo(path).absolutePath());
  const QString file = QFileInfo(path).fileName();
  parts_.jobs.start(
      tr("Reading %1").arg(file),
      [path, file, scan = parts_.scan()](const Progress& progress) {
        Imported<Skeleton> read = readReference(path);
        progress.update(0.9);
        requireComparable(read.value, file.toStdString());
        const auto other = scan ? scanOfReference(path) : std::nullopt;
        const bool isOfScan = other && other->hash == scan->hash && other->size == scan->size;
        return std::pair(std::move(read), isOfScan);
      },
      [this, path](std::pair<Imported<Skeleton>, bool> done) {
        Imported<Skeleton> read = std::move(done.first);
        set({.skeleton = std::move(read.value), .path = path, .isOfScan = done.second});
        QStringList notes = {tr("%1 is the reference now").arg(name())};
        for (const ShownMessage& note : firstNotes(read.notes))
          notes.append(shownText(note));
        emit noted(notes.join(QStringLiteral("; ")));
        emit outdated(); // of one refused
        emit loaded();
      });
}

void ReferenceFlow::takeVersion(Skeleton skeleton, const QString& name) {
  parts_.jobs.requireIdle();
  requireComparable(skeleton, name.toStdString());
  Reference version{.skeleton = std::move(skeleton), .path = name, .isVersion = true};
  if (isVersion_)
    version.before = before_;
  else if (skeleton_)
    version.before.push_back({.skeleton = *skeleton_, .path = path_, .isOfScan = isOfScan_});
  set(std::move(version));
  emit noted(tr("The plant is compared with “%1”").arg(name));
  emit outdated();
  emit loaded();
}

void ReferenceFlow::lay(const Eigen::Isometry3d& motion) {
  if (!skeleton_) return;
  laid_ = moved(*skeleton_, motion);
  parts_.view.setReference(laid_);
}

void ReferenceFlow::show(const std::string& text) {
  set(referenceFrom(text));
}

void ReferenceFlow::set(Reference reference) {
  text_ = textOf(reference);
  path_ = reference.path;
  isVersion_ = reference.isVersion;
  isOfScan_ = reference.isOfScan;
  before_ = std::move(reference.before);
  skeleton_ = reference.skeleton.isEmpty()
                  ? nullptr
                  : std::make_shared<const Skeleton>(std::move(reference.skeleton));
  laid_ = skeleton_ ? *skeleton_ : Skeleton();
  parts_.view.setReference(laid_);
  parts_.actions["remove_reference"]->setEnabled(skeleton_ != nullptr);
  parts_.actions["layer_reference"]->setVisible(skeleton_ != nullptr);
  refreshBeside();
  emit changed();
}

bool ReferenceFlow::takesDropped(const QStringList& paths) {
  if (parts_.document.skeleton().isEmpty() || paths.size() != 1 || !isStructure(paths.front()))
    return false;
  // Later: the program that it was dragged from waits for the drop to end.
  QTimer::singleShot(0, this, [this, paths] { askAbout(paths); });
  return true;
}

void ReferenceFlow::askAbout(const QStringList& paths) {
  const QString file = QFileInfo(paths.front()).fileName();
  QMessageBox box(QMessageBox::NoIcon, tr("A structure was dropped"),
                  tr("<b>Open %1, or compare the plant with it?</b>").arg(file.toHtmlEscaped()),
                  QMessageBox::NoButton, &parts_.window);
  box.setInformativeText(tr("Opened, it takes the place of the skeleton; as the reference, it is "
                            "shown beside it."));
  const QPushButton* compare = box.addButton(tr("Load as Reference"), QMessageBox::AcceptRole);
  const QPushButton* open = box.addButton(tr("Open"), QMessageBox::DestructiveRole);
  box.setEscapeButton(box.addButton(tr("Cancel"), QMessageBox::RejectRole));
  box.exec();
  if (box.clickedButton() == open) emit openRequested(paths);
  if (box.clickedButton() != compare) return;
  parts_.actions.guarded(
      [&] {
        load(paths.front());
        return true;
      },
      Refusal::inBanner);
}

} // namespace espalier
