#include "app/window/evaluate/versions_flow.h"

#include "app/window/evaluate/reference_flow.h"
#include "app/window/files/project_flow.h"
#include "app/window/frame/action_set.h"
#include "app/window/frame/menu_letters.h"
#include "core/base/error.h"
#include "core/project/corrections.h"
#include "ui/document/plant_document.h"
#include "ui/document/time_text.h"

#include <QAction>
#include <QDateTime>
#include <QInputDialog>
#include <QMainWindow>
#include <QMenu>

#include <algorithm>
#include <memory>
#include <ranges>
#include <utility>

namespace espalier {
namespace {

/// "name · Anna, 26 Nov 2026, 17:03"
QString withMaker(const QString& name, const std::string& author, std::int64_t time) {
  const QString who = QString::fromStdString(author);
  return name + QStringLiteral(" · ") + (who.isEmpty() ? who : who + ", ") + momentText(time);
}

} // namespace

VersionsFlow::VersionsFlow(const Parts& parts) : parts_(parts) {
  parts_.actions.beginSection(tr("File"));
  parts_.actions.add({.id = "name_version",
                      .text = tr("&Name This Version…"),
                      .help = tr("Keeps the skeleton as it is now in the project, under a name"),
                      .keys = QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_V),
                      .menu = "file/versions"},
                     [this] { name(); });
  parts_.actions.add(
      {.id = "compare_version",
       .text = tr("&Compare With Version…"),
       .help = tr("Compares the plant with a version that was named, or the end of a day before"),
       .keys = QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_V),
       .menu = "file/versions"},
      [this] { compare(); });
  parts_.actions.place("file/versions", [this](QMenu& menu) {
    QMenu* removal = menu.addMenu(tr("&Remove"));
    removal->setObjectName("remove_version");
    connect(removal, &QMenu::aboutToShow, this, [this, removal] { fillRemoval(*removal); });
  });
}

bool VersionsFlow::isNamed(const QString& name) const {
  return std::ranges::any_of(parts_.projects.versions(), [&](const PlantVersion& version) {
    return version.name == name.toStdString();
  });
}

void VersionsFlow::name() {
  const PlantDocument& document = parts_.document;
  document.requireEditable();
  if (document.skeleton().isEmpty())
    throw Error(tr("there is no skeleton to keep: make one first").toStdString());
  if (!parts_.projects.isNamed())
    throw Error(tr("only a project keeps versions: save the plant as one first").toStdString());
  QString proposed;
  for (int number = 1; proposed.isEmpty() || isNamed(proposed); ++number)
    proposed = tr("Version %1").arg(number);
  QInputDialog dialog(&parts_.window);
  dialog.setObjectName("name_version");
  dialog.setWindowTitle(tr("Name This Version"));
  dialog.setLabelText(tr("Name:"));
  dialog.setTextValue(proposed);
  dialog.setOkButtonText(tr("Keep"));
  if (dialog.exec() != QDialog::Accepted) return;
  const QString name = dialog.textValue().simplified();
  if (name.isEmpty()) throw Error(tr("a version needs a name").toStdString());
  parts_.projects.addVersion({.name = name.toStdString(),
                              .author = parts_.projects.author().toStdString(),
                              .time = QDateTime::currentMSecsSinceEpoch(),
                              .skeleton = document.skeleton()});
  emit noted(tr("The project keeps this state as “%1”").arg(name));
}

std::vector<VersionsFlow::Choice> VersionsFlow::choices() const {
  std::vector<Choice> all;
  for (const PlantVersion& version : parts_.projects.versions()) {
    const QString name = QString::fromStdString(version.name);
    all.push_back({name, withMaker(name, version.author, version.time),
                   [skeleton = version.skeleton] { return skeleton; }});
  }
  std::ranges::reverse(all);
  const auto history = std::make_shared<const History>(parts_.document.history());
  const auto done = std::span(history->steps).first(history->position);
  std::vector<std::size_t> ends = endsOfDays(done, [](std::int64_t time) {
    return QDateTime::fromMSecsSinceEpoch(time).date().toJulianDay();
  });
  std::ranges::reverse(ends);
  for (const std::size_t end : ends) {
    const HistoryStep& last = done[end - 1];
    const QString name =
        tr("the end of %1").arg(dayText(QDateTime::fromMSecsSinceEpoch(last.time).date()));
    all.push_back({name, withMaker(name, last.author, last.time),
                   [history, end] { return skeletonAt(*history, end); }});
  }
  const PlantBeginning beginning = beginningOfHandWork(*history);
  if (!beginning.skeleton.isEmpty() && beginning.skeleton != history->skeleton) {
    const QString name = beginning.isReconstructed ? tr("the reconstruction, before work by hand")
                                                   : tr("what was opened, before any edit");
    all.push_back({name, name, [skeleton = beginning.skeleton] { return skeleton; }});
  }
  return all;
}

void VersionsFlow::compare() {
  if (parts_.document.skeleton().isEmpty())
    throw Error(tr("there is no skeleton to compare: make one first").toStdString());
  const std::vector<Choice> all = choices();
  if (all.empty())
    throw Error(tr("there is no other state of this plant yet: name this version before you go on")
                    .toStdString());
  QStringList texts;
  for (const Choice& choice : all)
    texts.append(choice.text);
  QInputDialog dialog(&parts_.window);
  dialog.setObjectName("compare_version");
  dialog.setWindowTitle(tr("Compare With Version"));
  dialog.setLabelText(tr("Compare the plant as it is now with:"));
  dialog.setOption(QInputDialog::UseListViewForComboBoxItems);
  dialog.setComboBoxItems(texts);
  dialog.setTextValue(texts.front());
  dialog.setOkButtonText(tr("Compare"));
  dialog.resize(460, 280);
  if (dialog.exec() != QDialog::Accepted) return;
  const qsizetype at = texts.indexOf(dialog.textValue());
  if (at < 0) return;
  const Choice& choice = all[static_cast<std::size_t>(at)];
  parts_.reference.takeVersion(choice.skeleton(), choice.name);
}

void VersionsFlow::fillRemoval(QMenu& menu) {
  menu.clear();
  for (const PlantVersion& version : std::views::reverse(parts_.projects.versions())) {
    const QString name = QString::fromStdString(version.name);
    const QString text = entryText(withMaker(name, version.author, version.time));
    menu.addAction(text, this, [this, name] {
      parts_.actions.guarded(
          [&] {
            remove(name);
            return true;
          },
          Refusal::inBanner);
    });
  }
  if (menu.isEmpty()) menu.addAction(tr("None yet"))->setEnabled(false);
}

void VersionsFlow::remove(const QString& name) {
  const auto& all = parts_.projects.versions();
  const auto found = std::ranges::find(all, name.toStdString(), &PlantVersion::name);
  if (found == all.end()) return;
  PlantVersion version = *found;
  parts_.projects.removeVersion(version.name);
  emit reported(
      {.text = tr("The project no longer keeps %1").arg(name),
       .actions = {{tr("Keep It"), [this, version] { parts_.projects.addVersion(version); }}}});
}

} // namespace espalier
