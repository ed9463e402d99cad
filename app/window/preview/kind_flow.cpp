#include "app/window/preview/kind_flow.h"

#include "app/window/frame/action_set.h"
#include "core/base/error.h"
#include "ui/document/plant_document.h"
#include "ui/document/shown_text.h"
#include "ui/panels/kind_line.h"
#include "ui/panels/pipeline_panel.h"

#include <QAction>

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

QString percentOf(double share) {
  return QString::number(std::lround(100 * share));
}

/// With how probable it is: "Herb (87 %)".
QString labelOf(const KindOfScan& kind) {
  const double most = 0.99; // it is a guess
  return QStringLiteral("%1 (%2\u00a0%)")
      .arg(shownText(presetFor(kind.likely.kind).label),
           percentOf(std::min(kind.likely.probability, most)));
}

} // namespace

KindFlow::KindFlow(const Parts& parts) : parts_(parts), job_(parts.queue, JobPriority::background) {
  parts_.actions.beginSection(tr("Settings of the Steps"));
  QAction* take = parts_.actions.add(
      {.id = "take_kind",
       .text = tr("Settings for This Plant"),
       .help = tr("Takes the settings for what the plant of the scan probably is, as the panel of "
                  "the pipeline says"),
       .menu = "skeleton/settings_for_kind"},
      [this] { this->take(); });
  line_ = new KindLine(*take);
  parts_.pipeline.addBelowScan(line_);
  PlantDocument& document = parts_.document;
  for (auto signal :
       {&PlantDocument::scanChanged, &PlantDocument::leftOutChanged, &PlantDocument::upChanged,
        &PlantDocument::unitChanged, &PlantDocument::skeletonReplaced})
    connect(&document, signal, this, &KindFlow::guess);
  connect(&document, &PlantDocument::skeletonEdited, this, &KindFlow::refresh);
  connect(&parts_.pipeline, &PipelinePanel::changed, this, &KindFlow::refresh);
  connect(&parts_.pipeline, &PipelinePanel::replaced, this, &KindFlow::refresh);
  refresh();
}

void KindFlow::guess() {
  job_.cancel();
  kind_.reset();
  refresh();
  const Scan* scan = parts_.document.scan();
  if (scan == nullptr || !parts_.document.skeleton().isEmpty()) return;
  const PipelineOptions options{.root = parts_.document.root(),
                                .up = parts_.document.up(),
                                .leftOut = parts_.document.leftOut()};
  const double meters = metersIn(parts_.document.unit());
  job_.start(
      tr("Looking at the plant"),
      [cloud = scan->cloud(), options, meters](const Progress& progress) {
        return kindOfScan(cloud, options, meters, progress);
      },
      [this](const std::optional<KindOfScan>& kind) {
        kind_ = kind;
        refresh();
      });
}

void KindFlow::take() {
  if (!kind_) throw Error(tr("nothing is known of the plant: open a scan").toStdString());
  const NamedPreset& preset = presetFor(kind_->likely.kind);
  parts_.actions["preset_" + QString::fromStdString(preset.name)]->trigger();
}

/// Whether the steps are set as they are for that kind already.
bool KindFlow::isTaken() const {
  const PipelineOptions now = parts_.pipeline.options();
  const PipelineOptions& wanted = presetFor(kind_->likely.kind).options;
  return now.settings == wanted.settings && now.methods == wanted.methods;
}

void KindFlow::refresh() {
  parts_.actions["take_kind"]->setEnabled(kind_ && !isTaken());
  if (!kind_ || !parts_.document.skeleton().isEmpty()) return line_->show({}, {});
  const auto& shares = kind_->shares;
  line_->show((isTaken() ? tr("Perhaps: %1. The settings are those for it") : tr("Perhaps: %1"))
                  .arg(labelOf(*kind_)),
              tr("A guess that is good for simulated plants and often wrong for real ones: other "
                 "settings are under Skeleton > Settings of the Steps.\n\nOf its points, %1 % are "
                 "of wood, %2 % of petioles, %3 % of blades and %4 % of needles, as far as their "
                 "shapes show")
                  .arg(percentOf(shares[0]), percentOf(shares[1]), percentOf(shares[2]),
                       percentOf(shares[3])));
}

} // namespace espalier
