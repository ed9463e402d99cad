#include "app/window/frame/ignoring_steps.h"
#include "app/window/frame/panel_dock.h"
#include "app/window/review/findings_flow.h"
#include "app/window/review/suspects_flow.h"
#include "ui/panels/suspects_panel.h"

#include <algorithm>
#include <utility>

namespace espalier {

void SuspectsFlow::toggleIgnored() {
  const auto row = panel_->current();
  if (!row || !current_) {
    emit noted(tr("Choose a finding or a doubt to ignore it"));
    return;
  }
  const What what = *current_;
  const bool isDoubt = std::holds_alternative<Doubt>(what);
  if (!panel_->suspects()[*row].isIgnored()) {
    ignore(what);
    parts_.ignoring.add({.text = isDoubt ? tr("Ignore a doubt") : tr("Ignore a finding"),
                         .undo = [this, what] { bringBack(what); },
                         .redo = [this, what] { ignore(what); }});
  } else {
    parts_.ignoring.add({.text = isDoubt ? tr("Show a doubt again") : tr("Show a finding again"),
                         .undo = [this, what, before = showAgain(what)] { ignore(what, before); },
                         .redo = [this, what] { bringBack(what); }});
  }
}

/// The list goes on to what takes its place.
void SuspectsFlow::ignore(const What& what, const std::vector<AnsweredDoubt>& as) {
  const auto row = rowOf(what);
  if (!as.empty())
    parts_.doubts.restore(as);
  else if (std::holds_alternative<Doubt>(what))
    parts_.doubts.ignore(std::get<Doubt>(what));
  else
    parts_.findings.ignore(std::get<Finding>(what));
  const std::size_t count = panel_->suspects().size();
  if (!row || panel_->current() || count == 0) return;
  const std::size_t next = std::min(*row, count - 1);
  panel_->setCurrent(next);
  choose(next); // keys act on what the list names
}

/// @return what left out a doubt: that it was ignored, or that no branch is missing
std::vector<AnsweredDoubt> SuspectsFlow::showAgain(const What& what) {
  if (std::holds_alternative<Doubt>(what)) return parts_.doubts.stopIgnoring(std::get<Doubt>(what));
  parts_.findings.stopIgnoring(std::get<Finding>(what));
  return {};
}

/// Shows it again, and goes there if it is listed.
void SuspectsFlow::bringBack(const What& what) {
  showAgain(what);
  const auto row = dock_->isShown() ? rowOf(what) : std::nullopt;
  if (!row) return;
  panel_->setCurrent(row);
  choose(*row);
}

} // namespace espalier
