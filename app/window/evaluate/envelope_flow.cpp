#include "app/window/evaluate/envelope_flow.h"

#include "app/window/files/file_filters.h"
#include "app/window/files/load_files.h"
#include "app/window/frame/action_set.h"
#include "app/window/frame/kept_json.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/io/atomic_file.h"
#include "core/io/structures/surface_files.h"
#include "ui/document/number_scale.h"
#include "ui/document/plant_document.h"
#include "ui/document/shown_message.h"
#include "ui/document/shown_text.h"
#include "ui/panels/trait_text.h"
#include "ui/view/plant_view.h"

#include <QAction>
#include <QFileDialog>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QMainWindow>

#include <algorithm>
#include <cmath>
#include <utility>

namespace espalier {
namespace {

/// What a fit needs, as it is when it begins.
struct Fit {
  std::shared_ptr<const PointCloud> cloud; // null: it is about the skeleton
  PointSet leftOut;
  Skeleton skeleton;
  UpAxis up = UpAxis::z;
  PlantScale scale;
  EnvelopeChoice choice;

  [[nodiscard]] Envelope run(const Progress& progress) const {
    const std::vector<double> values =
        envelopeValues(*choice.kind, choice.settings(), scale, 0); // lengths are in its unit
    return envelopeAbout(cloud ? placesOf(*cloud, leftOut) : placesOf(skeleton), up, *choice.kind,
                         values, progress);
  }
};

QString parameterText(const EnvelopeParameter& parameter, LengthUnit unit) {
  using Kind = EnvelopeParameter::Kind;
  if (parameter.kind == Kind::length) return formatLength(parameter.value, unit);
  if (parameter.kind == Kind::angle)
    return textOf({.kind = TraitKind::angle, .value = parameter.value}, unit);
  return parameter.value == std::floor(parameter.value) // a count
             ? formatCount(static_cast<std::size_t>(parameter.value))
             : numberText(parameter.value, 3);
}

QJsonObject jsonOfPlaces(const HandlePlaces& places) {
  QJsonObject json;
  for (const auto& [name, place] : places)
    json[QString::fromStdString(name)] = QJsonArray{place.out, place.level, place.across};
  return json;
}

HandlePlaces placesIn(const QJsonObject& json, const EnvelopeKind& kind) {
  HandlePlaces places;
  for (auto it = json.begin(); it != json.end(); ++it) {
    const std::string name = it.key().toStdString();
    if (std::ranges::find(kind.handles, name) == kind.handles.end()) refuse();
    const QJsonArray numbers = it.value().toArray(); // projects of before have two
    places[name] = {.out = numberIn(numbers.at(0)),
                    .level = numberIn(numbers.at(1)),
                    .across = numbers.size() > 2 ? numberIn(numbers.at(2)) : 0};
  }
  return places;
}

std::map<std::string, Rule> optionsIn(const QJsonObject& json, const EnvelopeKind& kind) {
  std::map<std::string, Rule> options;
  for (auto it = json.begin(); it != json.end(); ++it) {
    const std::string name = it.key().toStdString();
    const auto rule = ruleIn(it.value().toString().toStdString());
    if (!rule ||
        std::ranges::find(kind.form.options, name, &Option::name) == kind.form.options.end())
      refuse();
    options[name] = *rule;
  }
  return options;
}

/// What a text of a project says. Refuses what is not as it was written.
std::pair<EnvelopeChoice, HandlePlaces> stateIn(const std::string& text) {
  const QJsonObject json = QJsonDocument::fromJson(QByteArray::fromStdString(text)).object();
  const std::string name = json["kind"].toString().toStdString();
  const auto& kinds = envelopeKinds();
  const auto kind = std::ranges::find(
      kinds, name, [](const EnvelopeKind& each) -> const std::string& { return each.form.name; });
  if (kind == kinds.end()) refuse();
  return {{.kind = &*kind,
           .isOfSkeleton = json["of"].toString() == "skeleton",
           .options = optionsIn(json["options"].toObject(), *kind)},
          placesIn(json["places"].toObject(), *kind)};
}

} // namespace

EnvelopeFlow::EnvelopeFlow(const Parts& parts) : parts_(parts) {
  ActionSet& actions = parts_.window.actions;
  actions.beginSection(tr("Evaluate"));
  actions.add({.id = "write_envelope",
               .text = tr("Export Envelope…"),
               .help = tr("Writes the surface about the crown as a mesh, PLY or OBJ")},
              [this] { chooseFile(); });
  panel_ = new EnvelopePanel(*actions["write_envelope"]);
  dock_ = addDock(new PanelDock(
      parts_.window,
      {.id = "crown_envelope",
       .title = tr("Crown Envelope"),
       .text = tr("Crown Envelope…"),
       .help = tr("Draws a closed surface about the crown, and measures its volume and area"),
       .keys = {},
       .menu = "evaluate/envelope",
       .manual = "traits.md#the-envelope-of-the-crown"},
      besideThePlant, panel_, this));
  actions.place("evaluate/envelope", {"write_envelope"});
  timer_.setSingleShot(true);
  timer_.setInterval(250); // [ms]: a drag is followed when it rests
  connect(&timer_, &QTimer::timeout, this, &EnvelopeFlow::fit);
  connect(dock_, &PanelDock::shown, this, [this] {
    if (drawn_) parts_.view.setEnvelope(shown());
  });
  connect(panel_, &EnvelopePanel::changed, this, &EnvelopeFlow::takeChoice);
  connect(panel_, &EnvelopePanel::fitRequested, this, [this] {
    places_.clear();
    show();
    record(tr("Crown envelope: fit again"));
  });
  PlantDocument& document = parts_.document;
  for (auto signal :
       {&PlantDocument::skeletonReplaced, &PlantDocument::scanChanged, &PlantDocument::unitChanged,
        &PlantDocument::upChanged, &PlantDocument::leftOutChanged})
    connect(&document, signal, this, &EnvelopeFlow::takePlant);
  connect(&document, &PlantDocument::skeletonEdited, this, [this] {
    if (isOfSkeleton()) takePlant();
  });
  connect(&document, &PlantDocument::envelopeChanged, this, &EnvelopeFlow::takeStep);
  connect(&job_, &JobSlot::failed, this, &EnvelopeFlow::forget);
  connect(&job_, &JobSlot::progressed, this, &EnvelopeFlow::showProgress);
  PlantView& view = parts_.view;
  connect(&view, &PlantView::envelopeDragged, this, &EnvelopeFlow::drag);
  connect(&view, &PlantView::envelopeHovered, this, [this](std::optional<std::size_t> handle) {
    hovered_ = handle;
    emit hintChanged();
  });
  connect(&view, &PlantView::envelopeReleased, this, [this] { endDrag(true); });
  connect(&view, &PlantView::envelopeGivenBack, this, [this] { endDrag(false); });
  keepInProject({.name = "envelope",
                 .text = [this] { return parts_.document.envelope(); },
                 .show =
                     [this](const std::string& text) {
                       parts_.document.openEnvelope(text);
                       showText(parts_.document.envelope());
                     }});
  refreshPanel();
  forget();
}

void EnvelopeFlow::stop() {
  timer_.stop();
  choosing_ = {};
  job_.cancel();
}

void EnvelopeFlow::setPlantShown(bool isShown) {
  parts_.window.actions["write_envelope"]->setEnabled(isShown && drawn_.has_value());
}

bool EnvelopeFlow::isOfSkeleton() const {
  return choice_.isOfSkeleton || parts_.document.scan() == nullptr;
}

bool EnvelopeFlow::isOfChosenKind() const {
  return fitted_ && fittedKind_ == choice_.kind;
}

bool EnvelopeFlow::isByHand() const {
  return choice_.kind != nullptr && !places_.empty();
}

/// What was chosen last, for the history.
QString EnvelopeFlow::choiceText(const EnvelopeChoice& before) const {
  if (choice_.kind == nullptr) return tr("Crown envelope: none");
  const QString kind = shownText(choice_.kind->form.label);
  if (before.kind != choice_.kind) return tr("Crown envelope: %1").arg(kind);
  if (before.isOfSkeleton != choice_.isOfSkeleton)
    return choice_.isOfSkeleton ? tr("Crown envelope: about the skeleton")
                                : tr("Crown envelope: about the points");
  for (const Option& option : choice_.kind->form.options) {
    const auto was = before.options.find(option.name);
    const auto is = choice_.options.find(option.name);
    const bool wasSet = was != before.options.end();
    const bool isSet = is != choice_.options.end();
    if (wasSet != isSet || (isSet && was->second != is->second))
      return tr("Crown envelope: %1, %2").arg(kind, shownText(option.label));
  }
  return tr("Crown envelope: %1").arg(kind);
}

void EnvelopeFlow::takeChoice() {
  const EnvelopeChoice before = std::exchange(choice_, panel_->choice());
  if (before.kind != choice_.kind) places_.clear();
  if (choosing_.isNone()) choosing_ = Gesture::begin();
  record(choiceText(before), choosing_);
  takeNew();
}

/// Draws another choice once it rests.
void EnvelopeFlow::takeNew() {
  if (choice_.kind == nullptr) return forget();
  isFresh_ = false;
  panel_->setStale(true);
  refreshPanel(); // another kind has fields of its own
  if (drawn_ && !isOfChosenKind()) parts_.view.setEnvelope(shown()); // and handles
  timer_.start();
}

void EnvelopeFlow::record(const QString& step, Gesture gesture) {
  parts_.document.setEnvelope(step, text(), gesture);
}

/// Undo and redo lead here; of a step made here, all is shown already.
void EnvelopeFlow::takeStep() {
  emit keptChanged();
  if (parts_.document.envelope() == text()) return;
  try {
    showText(parts_.document.envelope());
  } catch (const Error& error) {
    emit failed(shownText(error));
  }
}

void EnvelopeFlow::takePlant() {
  refreshPanel();
  if (choice_.kind == nullptr) return;
  isFresh_ = false;
  emit changed();
  panel_->setStale(true);
  timer_.start();
}

void EnvelopeFlow::refreshPanel() {
  const PlantDocument& document = parts_.document;
  panel_->setHasPoints(document.scan() != nullptr);
  panel_->setScale(isOfSkeleton() ? scaleOf(document.skeleton(), document.up()) : document.scale(),
                   symbol(document.unit()));
}

void EnvelopeFlow::fit() {
  const PlantDocument& document = parts_.document;
  choosing_ = {};
  if (choice_.kind == nullptr) return;
  if (isOfSkeleton() && document.skeleton().isEmpty())
    return forget(document.scan() == nullptr ? tr("There is no plant to draw it about.")
                                             : tr("There is no skeleton to draw it about."));
  Fit asked{.cloud = isOfSkeleton() ? nullptr : document.scan()->cloud(),
            .leftOut = document.leftOut(),
            .skeleton = isOfSkeleton() ? document.skeleton() : Skeleton(),
            .up = document.up(),
            .scale =
                isOfSkeleton() ? scaleOf(document.skeleton(), document.up()) : document.scale(),
            .choice = choice_};
  begun_.start();
  job_.start(
      tr("Crown envelope"),
      [asked = std::move(asked)](const Progress& progress) { return asked.run(progress); },
      [this, kind = choice_.kind](Envelope fitted) { take(std::move(fitted), *kind); });
}

/// Of what takes a moment; a shape of another kind is no longer what is asked for.
void EnvelopeFlow::showProgress(double fraction) {
  constexpr qint64 moment = 300; // [ms]
  if (begun_.elapsed() < moment) return;
  const QString words = tr("Drawing it… %1 %").arg(static_cast<int>(100 * fraction));
  drawn_&& isOfChosenKind() ? panel_->showDrawing(words) : forgetDrawn(words);
}

void EnvelopeFlow::take(Envelope fitted, const EnvelopeKind& kind) {
  fitted_ = std::move(fitted);
  fittedKind_ = &kind;
  isFresh_ = true;
  show();
}

void EnvelopeFlow::forget(const QString& words) {
  stop();
  forgetDrawn(words);
}

void EnvelopeFlow::forgetDrawn(const QString& words) {
  fitted_.reset();
  drawn_.reset();
  isFresh_ = false;
  parts_.view.setEnvelope(std::nullopt);
  if (choice_.kind != nullptr || words.isEmpty())
    panel_->showWords(choice_.kind == nullptr
                          ? tr("Choose a shape: it is drawn about the plant, and measured. From "
                               "height leaves out a bare stem.")
                          : words);
  parts_.window.actions["write_envelope"]->setEnabled(false);
  emit changed();
}

void EnvelopeFlow::show() {
  if (!isOfChosenKind()) return; // the one that is chosen is still to be fitted
  drawn_ = isByHand() ? draggedEnvelope(*fitted_, parts_.document.up(), *choice_.kind, places_)
                      : *fitted_;
  parts_.view.setEnvelope(shown());
  panel_->showNumbers(numbers(), handleText(), isByHand());
  parts_.window.actions["write_envelope"]->setEnabled(true);
  emit changed();
}

ShownEnvelope EnvelopeFlow::shown() const {
  ShownEnvelope result{.mesh = std::make_shared<const SurfaceMesh>(drawn_->mesh),
                       .label = formatVolume(drawn_->volume, parts_.document.unit())};
  if (!dock_->isShown() || !isOfChosenKind()) return result;
  const UpAxis up = parts_.document.up();
  for (const EnvelopeHandle& handle : envelopeHandles(*drawn_, up, *choice_.kind))
    result.handles.push_back({.label = numberedText(handle.label),
                              .place = handle.place,
                              .up = handle.up,
                              .outward = handle.outward,
                              .isFree = handle.isFree});
  return result;
}

QString EnvelopeFlow::hint() const {
  if (!hovered_ || !drawn_ || !isOfChosenKind()) return {};
  const std::vector<EnvelopeHandle> handles =
      envelopeHandles(*drawn_, parts_.document.up(), *choice_.kind);
  if (*hovered_ >= handles.size()) return {};
  return tr("Drag: move %1   Esc: put it back while you drag")
      .arg(numberedText(handles[*hovered_].label));
}

QString EnvelopeFlow::handleText() const {
  if (!choice_.kind->hasHandles())
    return tr("It follows from the plant alone: it has no handles to drag.");
  return isByHand() ? tr("By hand: handles were dragged.")
                    : tr("Drag its handles to set it by hand.");
}

std::vector<EnvelopePanel::Number> EnvelopeFlow::numbers() const {
  const LengthUnit unit = parts_.document.unit();
  const auto area = [&](double value) {
    return textOf({.kind = TraitKind::area, .value = value}, unit);
  };
  std::vector<EnvelopePanel::Number> result = {
      {tr("Volume"), formatVolume(drawn_->volume, unit)},
      {tr("Area"), area(drawn_->area)},
      {tr("Height"), formatLength(drawn_->height, unit)},
      {tr("Crown diameter"), formatLength(drawn_->diameter, unit),
       tr("Of a circle as large as its convex outline from above")}};
  using Kind = EnvelopeParameter::Kind;
  for (const EnvelopeParameter& each : ownParameters(*drawn_)) {
    if (each.kind == Kind::coordinate) continue; // the file of numbers has them
    QString label = numberedText(each.label);
    label[0] = label[0].toUpper();
    result.push_back({label, parameterText(each, unit)});
  }
  return result;
}

void EnvelopeFlow::drag(std::size_t handle, const Eigen::Vector3d& to) {
  if (!isOfChosenKind()) return; // another was chosen meanwhile
  const UpAxis up = parts_.document.up();
  const std::vector<EnvelopeHandle> handles = envelopeHandles(*drawn_, up, *choice_.kind);
  const std::string& name = handles[handle].name;
  dragged_ = numberedText(handles[handle].label);
  places_[name] = draggedTo(*drawn_, up, *choice_.kind, name, to);
  show();
}

void EnvelopeFlow::endDrag(bool isKept) {
  if (parts_.document.envelope() == text()) return;
  if (!isKept) {
    showText(parts_.document.envelope());
  } else {
    record(tr("Crown envelope: drag %1").arg(dragged_));
    if (!drawn_) return;
    emit noted(
        tr("The envelope holds %1 now").arg(formatVolume(drawn_->volume, parts_.document.unit())));
  }
}

std::optional<ReportedEnvelope> EnvelopeFlow::reported() const {
  if (!drawn_ || !isFresh_) return std::nullopt;
  return ReportedEnvelope{.kind = choice_.kind->form.name,
                          .label = choice_.kind->form.label,
                          .isOfSkeleton = isOfSkeleton(),
                          .isByHand = isByHand(),
                          .isUsual = !isByHand() && choice_.options.empty() &&
                                     (isOfSkeleton() || parts_.document.leftOut().isEmpty()),
                          .envelope = *drawn_};
}

void EnvelopeFlow::chooseFile() {
  QFileDialog dialog(&parts_.window.window, tr("Export the envelope"), {},
                     tr("PLY surface (*.ply);;OBJ surface (*.obj)"));
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix("ply");
  connect(&dialog, &QFileDialog::filterSelected, &dialog, [&dialog](const QString& filter) {
    dialog.setDefaultSuffix(filter.contains("obj") ? "obj" : "ply");
  });
  proposeBeside(dialog, parts_.document, ".envelope.ply");
  if (dialog.exec() == QDialog::Accepted) write(dialog.selectedFiles().front());
}

void EnvelopeFlow::write(const QString& path) {
  if (!drawn_) throw Error(tr("there is no envelope: choose a shape first").toStdString());
  const std::string extension = lowerCase(toPath(path).extension().string());
  if (extension != ".ply" && extension != ".obj")
    throw Error(tr("%1: envelopes are written as PLY or OBJ: choose a name that ends in .ply or "
                   ".obj")
                    .arg(path)
                    .toStdString());
  writeAtomically(toPath(path), [&](std::ostream& out) {
    extension == ".ply" ? writePlySurface(out, drawn_->mesh) : writeObjSurface(out, drawn_->mesh);
  });
  emit noted(tr("Wrote %1: %2 triangles").arg(path, formatCount(drawn_->mesh.triangles.size())));
}

std::string EnvelopeFlow::text() const {
  if (choice_.kind == nullptr) return {};
  QJsonObject options;
  for (const auto& [name, rule] : choice_.options)
    options[QString::fromStdString(name)] = QString::fromStdString(rule.text());
  const QJsonObject json{{"kind", QString::fromStdString(choice_.kind->form.name)},
                         {"of", choice_.isOfSkeleton ? "skeleton" : "points"},
                         {"options", options},
                         {"places", jsonOfPlaces(places_)}};
  return QJsonDocument(json).toJson(QJsonDocument::Compact).toStdString();
}

void EnvelopeFlow::showText(const std::string& text) {
  if (text.empty()) return showState({}, {});
  const QString refusal = tr("the crown envelope of this project cannot be read: choose it again");
  try {
    const auto [choice, places] = readKept(refusal, [&] { return stateIn(text); });
    showState(choice, places);
  } catch (const Error&) {
    showState({}, {});
    throw;
  }
}

/// Where only handles stand elsewhere, all is there to draw it at once.
void EnvelopeFlow::showState(const EnvelopeChoice& choice, const HandlePlaces& places) {
  const bool isDrawn = fitted_ && isFresh_ && choice == choice_;
  choice_ = choice;
  places_ = places;
  if (isDrawn) return show();
  panel_->setChoice(choice_);
  forget();
  takePlant();
}

} // namespace espalier
