#include "app/window/reconstruct_flow.h"

#include "core/base/error.h"
#include "ui/document/plant_document.h"
#include "ui/jobs/job_runner.h"

#include <QElapsedTimer>
#include <QLocale>

namespace espalier {

ReconstructFlow::ReconstructFlow(PlantDocument& document, JobRunner& jobs, QObject* parent)
    : QObject(parent), document_(document), jobs_(jobs),
      pipeline_(std::make_shared<SharedPipeline>()) {
  connect(&jobs_, &JobRunner::finished, this, [this] { isRunning_ = false; });
  for (auto signal : {&PlantDocument::scanChanged, &PlantDocument::skeletonReplaced})
    connect(&document_, signal, this, [this] { used_.reset(); });
}

void ReconstructFlow::start(const PipelineOptions& options, const Step* last) {
  if (document_.scan() == nullptr)
    throw Error(tr("there is no scan to reconstruct from: open one first").toStdString());
  document_.requireEditable();
  if (jobs_.isRunning())
    throw Error(
        tr("%1 is still running: wait for it, or cancel it").arg(jobs_.name()).toStdString());
  PipelineOptions ofKept = options;
  ofKept.leftOut = document_.leftOut();
  isRunning_ = true;
  QElapsedTimer elapsed;
  elapsed.start();
  jobs_.start(
      tr("Reconstructing"),
      [pipeline = pipeline_, cloud = document_.scan()->cloud(), options = ofKept,
       to = last != nullptr ? last->name : std::string()](const Progress& progress) {
        return pipeline->run(cloud, options, progress, to);
      },
      [this, elapsed, last, options](const Reconstruction& result) {
        used_ = options;
        show(result, last, static_cast<double>(elapsed.elapsed()) / 1000);
      });
}

PipelinePanel::Telling ReconstructFlow::telling() const {
  return [costs = pipeline_->costs()](const Step& step) -> PipelinePanel::Told {
    const auto cost = costs.find(step.name);
    if (cost == costs.end()) return {};
    const auto& [seconds, bytes] = cost->second;
    const QString time = QLocale().toString(seconds, 'f', seconds < 0.995 ? 2 : 1);
    const QString memory = QLocale().toString(static_cast<double>(bytes) / 1e6, 'f', 0);
    return {.note = seconds < 0.005 ? QString() : tr("%1 s").arg(time),
            .details = tr("Last run: %1 s, %2 MB more memory at most").arg(time, memory)};
  };
}

void ReconstructFlow::show(const Reconstruction& result, const Step* last, double seconds) {
  const QString time = QLocale().toString(seconds, 'f', 1);
  const std::string end = last != nullptr ? last->name : std::string();
  if (last != nullptr && result.skeleton.isEmpty()) {
    document_.contract(QString::fromStdString(last->label), result.contracted);
    emit done(tr("%1 done in %2 s").arg(QString::fromStdString(last->label), time), end);
    return;
  }
  document_.reconstruct(tr("Reconstruct"), result.skeleton, result.contracted);
  emit done(
      tr("%1 nodes reconstructed in %2 s").arg(formatCount(document_.skeleton().size()), time),
      end);
}

} // namespace espalier
