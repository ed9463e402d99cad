#include "ui/dialogs/shortcut_sheet.h"

#include <QAction>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include <utility>
#include <vector>

namespace espalier {
namespace {

struct Section {
  QString name;
  std::vector<std::pair<QString, QString>> rows; // keys, what they do
  [[nodiscard]] std::size_t height() const { return rows.size() + 2; }
};

Section mouseSection() {
  const auto tr = [](const char* text) { return ShortcutSheet::tr(text); };
  return {tr("Mouse"),
          {{tr("Drag"), tr("Turn")},
           {tr("Right drag"), tr("Pan")},
           {tr("Middle drag, wheel"), tr("Zoom")},
           {tr("Ctrl+drag"), tr("Turn, over nodes too")},
           {tr("Ctrl+wheel"), tr("Radius of the selected nodes")},
           {tr("Click"), tr("Select a node")},
           {tr("Shift+click"), tr("Add or remove a node")},
           {tr("Drag a node"), tr("Move it")},
           {tr("Double click"), tr("Turn around this place")},
           {tr("Right click"), tr("Menu of the node")},
           {tr("Esc"), tr("Leave a gesture, nothing changed")}}};
}

std::vector<Section> sectionsOf(const QList<QAction*>& actions) {
  std::vector<Section> sections = {mouseSection()};
  for (const QAction* action : actions) {
    if (action->shortcut().isEmpty()) continue;
    const QString name = action->property("section").toString();
    if (sections.back().name != name) sections.push_back({name, {}});
    sections.back().rows.emplace_back(action->shortcut().toString(QKeySequence::NativeText),
                                      action->property("name").toString());
  }
  return sections;
}

QWidget* makeSection(const Section& section, QWidget* parent) {
  auto* widget = new QWidget(parent);
  auto* grid = new QGridLayout(widget);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(12);
  grid->setVerticalSpacing(4);
  grid->setColumnStretch(1, 1);
  auto* title = new QLabel(section.name, widget);
  title->setProperty("role", "section");
  grid->addWidget(title, 0, 0, 1, 2);
  int row = 0;
  for (const auto& [keys, act] : section.rows) {
    auto* keyLabel = new QLabel(keys, widget);
    keyLabel->setProperty("role", "key");
    grid->addWidget(keyLabel, ++row, 0, Qt::AlignLeft);
    grid->addWidget(new QLabel(act, widget), row, 1);
  }
  return widget;
}

/// The sections one below the other, in `count` columns of about the same height.
QHBoxLayout* makeColumns(const std::vector<Section>& sections, std::size_t count, QWidget* parent) {
  std::size_t total = 0;
  for (const Section& section : sections)
    total += section.height();
  auto* columns = new QHBoxLayout;
  columns->setSpacing(32);
  QVBoxLayout* column = nullptr;
  std::size_t used = 0;
  for (const Section& section : sections) {
    const auto begun = static_cast<std::size_t>(columns->count());
    if (used * count >= begun * total) {
      if (column != nullptr) column->addStretch(1);
      column = new QVBoxLayout;
      column->setSpacing(16);
      columns->addLayout(column);
    }
    column->addWidget(makeSection(section, parent));
    used += section.height();
  }
  column->addStretch(1);
  return columns;
}

} // namespace

ShortcutSheet::ShortcutSheet(const QList<QAction*>& actions, QWidget* parent) : QDialog(parent) {
  setObjectName("shortcut_sheet");
  setWindowTitle(tr("Shortcuts"));
  setAttribute(Qt::WA_DeleteOnClose);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* page = new QVBoxLayout(this);
  page->setContentsMargins(24, 20, 24, 16);
  page->setSpacing(16);
  page->addLayout(makeColumns(sectionsOf(actions), 3, this));
  page->addWidget(buttons);
}

} // namespace espalier
