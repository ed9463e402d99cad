#include "app/window/preview/pipeline_flow.h"

#include "app/window/preview/reconstruct_flow.h"
#include "core/pipeline/kept_options.h"
#include "ui/document/plant_document.h"
#include "ui/panels/pipeline_panel.h"

namespace espalier {

PipelineFlow::PipelineFlow(const Parts& parts) : parts_(parts) {
  addDock(new PanelDock(parts_.window,
                        {.id = "pipeline",
                         .title = tr("Pipeline"),
                         .text = tr("Pipeline"),
                         .help = tr("Shows or hides this panel"),
                         .keys = Qt::Key_F6,
                         .manual = "reconstruct.md"},
                        {.side = Qt::LeftDockWidgetArea, .size = 252, .isShown = true},
                        &parts_.panel, this));
  keepOptions();
  connect(&parts_.panel, &PipelinePanel::changed, this, &PipelineFlow::keptChanged);
  connect(&parts_.document, &PlantDocument::upChanged, this, &PipelineFlow::keptChanged);
  connect(&parts_.reconstruct, &ReconstructFlow::done, this, &PipelineFlow::keptChanged);
}

void PipelineFlow::keepOptions() {
  keepInProject({.name = keptOptionsName, // empty: all is as the rules say
                 .text =
                     [this] {
                       const PipelineOptions options = parts_.panel.options();
                       return options != PipelineOptions() ? keptText(options) : std::string();
                     },
                 .show =
                     [this](const std::string& text) {
                       const PipelineOptions options =
                           text.empty() ? PipelineOptions() : keptOptions(text);
                       parts_.document.setUp(options.up);
                       parts_.document.setRoot(options.root);
                       parts_.panel.setOptions(options);
                       emit shown();
                     }});
  keepInProject({.name = "made_with",
                 .text = [this] { return parts_.reconstruct.usedText(); },
                 .show = [this](const std::string& text) { parts_.reconstruct.setUsed(text); }});
}

} // namespace espalier
