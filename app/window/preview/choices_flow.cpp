#include "app/window/preview/choices_flow.h"

#include "app/window/frame/action_set.h"
#include "app/window/preview/judge_flow.h"
#include "app/window/preview/sweep_flow.h"
#include "core/base/error.h"
#include "ui/document/time_text.h"

#include <QAction>
#include <QDateTime>

#include <utility>

namespace espalier {

ChoicesFlow::ChoicesFlow(const Parts& parts) : parts_(parts) {
  parts_.actions.beginSection(tr("Preview"));
  parts_.actions.add({.id = "record_choice",
                      .text = tr("Record the Choice"),
                      .help = tr("Keeps what is compared, or the sweep, with the project and in "
                                 "the report"),
                      .keys = QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_K),
                      .menu = "preview/choices"},
                     [this] { record(); });
  parts_.actions.add({.id = "forget_choice",
                      .text = tr("Forget the Last Choice Recorded"),
                      .help = tr("Takes the last one out of the project and the report"),
                      .menu = "preview/choices"},
                     [this] { forgetLast(); });
  keepInProject({.name = "choices",
                 .text = [this] { return text_; },
                 .show =
                     [this](const std::string& text) {
                       set(text.empty() ? std::vector<ChoiceRecord>() : readChoices(text));
                     }});
  connect(this, &ChoicesFlow::changed, this, &ChoicesFlow::keptChanged);
  set({});
}

void ChoicesFlow::record() {
  ChoiceRecord record =
      parts_.sweep.dock().isInFront() ? parts_.sweep.record() : parts_.judge.record();
  if (record.states.empty())
    throw Error(tr("there is nothing to record: show Preview in Numbers, or run a sweep, first")
                    .toStdString());
  record.time = momentText(QDateTime::currentDateTime());
  std::vector<ChoiceRecord> records = records_;
  records.push_back(std::move(record));
  set(std::move(records));
  emit noted(tr("Recorded: %1").arg(records_.back().title));
}

void ChoicesFlow::forgetLast() {
  if (records_.empty()) return;
  std::vector<ChoiceRecord> records = records_;
  const QString title = records.back().title;
  records.pop_back();
  set(std::move(records));
  emit noted(tr("Forgotten: %1").arg(title));
}

void ChoicesFlow::set(std::vector<ChoiceRecord> records) {
  records_ = std::move(records);
  text_ = records_.empty() ? std::string() : writeChoices(records_);
  parts_.actions["forget_choice"]->setEnabled(!records_.empty());
  emit changed();
}

} // namespace espalier
