#include "app/window/reconstruct_flow.h"

#include "core/base/error.h"
#include "ui/document/plant_document.h"
#include "ui/jobs/job_runner.h"

#include <QElapsedTimer>
#include <QLocale>

namespace espalier {

ReconstructFlow::ReconstructFlow(PlantDocument& document, JobRunner& jobs, QObject* parent)
    : QObject(parent), document_(document), jobs_(jobs), pipeline_(std::make_shared<Pipeline>()) {
  connect(&jobs_, &JobRunner::finished, this, [this] { isRunning_ = false; });
}

void ReconstructFlow::start(const PipelineOptions& options) {
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
      [pipeline = pipeline_, cloud = document_.scan()->cloud(), options = ofKept](
          const Progress& progress) { return pipeline->run(cloud, options, progress); },
      [this, elapsed](const Reconstruction& result) {
        show(result, static_cast<double>(elapsed.elapsed()) / 1000);
      });
}

void ReconstructFlow::show(const Reconstruction& result, double seconds) {
  document_.reconstruct(tr("Reconstruct"), result.skeleton, result.contracted);
  emit done(
      tr("%1 nodes reconstructed in %2 s")
          .arg(formatCount(document_.skeleton().size()), QLocale().toString(seconds, 'f', 1)));
}

} // namespace espalier
