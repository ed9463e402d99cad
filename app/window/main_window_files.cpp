// What files and projects tell the window, and what a project keeps of it.
#include "app/window/action_set.h"
#include "app/window/file_flow.h"
#include "app/window/main_window.h"
#include "app/window/options_text.h"
#include "app/window/preset_flow.h"
#include "app/window/preview_flow.h"
#include "app/window/project_flow.h"
#include "app/window/reconstruct_flow.h"
#include "app/window/view_options.h"
#include "ui/panels/message_banner.h"
#include "ui/panels/pipeline_panel.h"
#include "ui/panels/start_page.h"
#include "ui/panels/status_line.h"
#include "ui/view/plant_view.h"

#include <QFileInfo>

namespace espalier {
namespace {

/// Empty: all is as the rules say.
std::string textOf(const PipelineOptions& options) {
  return options != PipelineOptions() ? keptText(options) : std::string();
}

} // namespace

void MainWindow::connectFiles() {
  const auto showPlant = [this] {
    banner_->hide();
    const auto* scan = document_.scan();
    options_->setAvailable(scan != nullptr && !scan->cloud()->intensities().empty(),
                           scan != nullptr && !scan->cloud()->colors().empty());
    refreshEmptiness();
  };
  connect(projects_.get(), &ProjectFlow::opened, this, showPlant);
  connect(files_.get(), &FileFlow::opened, this, showPlant);
  connect(files_.get(), &FileFlow::opened, view_, &PlantView::faceAll); // after it has its size
  connect(projects_.get(), &ProjectFlow::scanFound, this, [this, showPlant] {
    showPlant();
    if (document_.skeleton().isEmpty()) view_->faceAll(); // there was nothing to look at
  });
  connect(files_.get(), &FileFlow::movedOntoScan, view_, &PlantView::frameAll);
  connect(files_.get(), &FileFlow::noted, this,
          [this](const QString& message) { banner_->showResult(message); });
  connect(files_.get(), &FileFlow::saved, this, [this](const QString& path) {
    banner_->hide(); // of what kept it from being saved before
    status_->showNote(tr("Saved %1").arg(QFileInfo(path).fileName()));
  });
}

void MainWindow::connectProjects() {
  const auto tell = [this](const ProjectFlow::Notice& notice) {
    MessageBanner::Actions actions;
    for (const ProjectFlow::Notice::Action& action : notice.actions)
      actions.push_back({action.text, [this, act = action.act] {
                           actions_->guarded(
                               [&] {
                                 act();
                                 return true;
                               },
                               Refusal::inBanner);
                         }});
    if (notice.isError)
      banner_->showError(notice.text, actions);
    else if (actions.empty())
      banner_->showResult(notice.text);
    else
      banner_->showOffer(notice.text, actions);
  };
  connect(projects_.get(), &ProjectFlow::told, this, tell);
  connect(files_.get(), &FileFlow::told, this, tell);
  projects_->keep({.name = "pipeline",
                   .text = [this] { return textOf(pipeline_->options()); },
                   .show =
                       [this](const std::string& text) {
                         const PipelineOptions options =
                             text.empty() ? PipelineOptions() : keptOptions(text);
                         document_.setUp(options.up);
                         document_.setRoot(options.root);
                         pipeline_->setOptions(options);
                         preview_->keepChoices();
                       }});
  projects_->keep({.name = "made_with",
                   .text = [this] { return reconstruct_->usedText(); },
                   .show = [this](const std::string& text) { reconstruct_->setUsed(text); }});
  connect(reconstruct_.get(), &ReconstructFlow::usedChanged, this,
          [this] { reconstruct_->showUsed(*pipeline_); });
  projects_->keep({.name = "view",
                   .text = [this] { return options_->text(); },
                   .show = [this](const std::string& text) { options_->show(text); }});
  connect(pipeline_, &PipelinePanel::changed, projects_.get(), &ProjectFlow::noteChange);
  connect(&document_, &PlantDocument::upChanged, projects_.get(), &ProjectFlow::noteChange);
  connect(presets_.get(), &PresetFlow::chosen, projects_.get(), &ProjectFlow::noteChange);
  connect(projects_.get(), &ProjectFlow::chosen, this,
          [this](const QString& path) { open({path}); });
  connect(projects_.get(), &ProjectFlow::sessionsChanged, this, [this] {
    QStringList texts;
    QStringList paths;
    for (const Session& session : projects_->sessions().waiting()) {
      texts.append(describe(session, QDateTime::currentDateTime()));
      paths.append(session.path);
    }
    start_->setSessions(texts, paths);
  });
}

} // namespace espalier
