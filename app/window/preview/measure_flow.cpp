#include "app/window/preview/measure_flow.h"

#include "ui/document/plant_document.h"
#include "ui/panels/measures_form.h"
#include "ui/panels/pipeline_panel.h"

#include <utility>

namespace espalier {

MeasureFlow::MeasureFlow(PlantDocument& document, JobQueue& queue, PipelinePanel& pipeline)
    : document_(document), pipeline_(pipeline), job_(queue, JobPriority::background) {
  for (auto signal :
       {&PlantDocument::scanChanged, &PlantDocument::leftOutChanged, &PlantDocument::upChanged})
    connect(&document_, signal, this, &MeasureFlow::measure);
  connect(&document_, &PlantDocument::unitChanged, this, &MeasureFlow::show);
}

void MeasureFlow::measure() {
  measures_.reset();
  job_.cancel();
  show();
  const Scan* scan = document_.scan();
  if (scan == nullptr) return;
  job_.start([cloud = scan->cloud(), leftOut = document_.leftOut(), up = document_.up()](
                 const Progress& progress) { return scanMeasures(*cloud, leftOut, up, progress); },
             [this](ScanMeasures measures) {
               measures_ = std::move(measures);
               show();
             });
}

void MeasureFlow::show() {
  MeasuresForm& form = pipeline_.measures();
  if (document_.scan() == nullptr)
    form.showNone();
  else if (measures_)
    form.showMeasured(*measures_, document_.unit());
  else
    form.showMeasuring();
}

} // namespace espalier
