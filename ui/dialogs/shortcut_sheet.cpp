#include "ui/dialogs/shortcut_sheet.h"

#include "ui/dialogs/key_bindings.h"
#include "ui/dialogs/keys_dialog.h"
#include "ui/document/manual_place.h"

#include <QAction>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>

#include <algorithm>
#include <functional>
#include <numeric>
#include <utility>
#include <vector>

namespace espalier {
namespace {

/// Those that stand in the menu; of the keypad, which many keyboards lack, also the others.
QString keysOf(const QAction& action) {
  const QList<QKeySequence> all = action.shortcuts();
  const bool isOfKeypad = all.front()[0].keyboardModifiers().testFlag(Qt::KeypadModifier);
  return isOfKeypad ? QKeySequence::listToString(all, QKeySequence::NativeText).replace("; ", ", ")
                    : all.front().toString(QKeySequence::NativeText);
}

struct Row {
  QString keys;
  QString does;
  const QAction* action = nullptr; // null: what the mouse does
};
struct Section {
  QString name;
  std::vector<Row> rows;
  [[nodiscard]] std::size_t height() const { return rows.size() + 2; }
};

Section mouseSection() {
  return {ShortcutSheet::tr("Mouse"),
          {{ShortcutSheet::tr("Drag"), ShortcutSheet::tr("Turn")},
           {ShortcutSheet::tr("Right drag"), ShortcutSheet::tr("Pan")},
           {ShortcutSheet::tr("Middle drag, wheel"), ShortcutSheet::tr("Zoom")},
           {ShortcutSheet::tr("Ctrl+drag"), ShortcutSheet::tr("Turn, over nodes too")},
           {ShortcutSheet::tr("Ctrl+wheel"), ShortcutSheet::tr("Radius of the selected nodes")},
           {ShortcutSheet::tr("Click"), ShortcutSheet::tr("Select a node")},
           {ShortcutSheet::tr("Shift+click"), ShortcutSheet::tr("Add or remove a node")},
           {ShortcutSheet::tr("Shift+drag"), ShortcutSheet::tr("Select in a box")},
           {ShortcutSheet::tr("Alt+drag"), ShortcutSheet::tr("Select in a lasso")},
           {ShortcutSheet::tr("Drag a node"), ShortcutSheet::tr("Move it")},
           {ShortcutSheet::tr("Double click"), ShortcutSheet::tr("Turn around this place")},
           {ShortcutSheet::tr("Right click"), ShortcutSheet::tr("Menu of the node")},
           {ShortcutSheet::tr("Esc"), ShortcutSheet::tr("Leave a gesture")}}};
}

std::vector<Section> sectionsOf(const QList<QAction*>& actions) {
  std::vector<Section> sections = {mouseSection()};
  for (const QAction* action : actions) {
    if (action->shortcut().isEmpty()) continue;
    const QString name = action->property("section").toString();
    auto section = std::ranges::find(sections, name, &Section::name);
    if (section == sections.end()) section = sections.insert(section, {name, {}});
    section->rows.push_back({keysOf(*action), action->property("name").toString(), action});
  }
  return sections;
}

using Change = std::function<void(const QAction*)>;

QWidget* makeKeys(const Row& row, const Change& change) {
  if (row.action == nullptr) {
    auto* label = new QLabel(row.keys);
    label->setProperty("role", "key");
    return label;
  }
  auto* button = new QPushButton(row.keys);
  button->setObjectName("keys_of_" + row.action->objectName());
  button->setProperty("role", "key");
  button->setAutoDefault(false);
  button->setToolTip(ShortcutSheet::tr("Change…"));
  button->setAccessibleName(ShortcutSheet::tr("%1: %2. Change").arg(row.does, row.keys));
  QObject::connect(button, &QPushButton::clicked, button,
                   [change, action = row.action] { change(action); });
  return button;
}

QWidget* makeSection(const Section& section, const Change& change, QWidget* parent) {
  auto* widget = new QWidget(parent);
  auto* grid = new QGridLayout(widget);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(12);
  grid->setVerticalSpacing(2);
  grid->setColumnStretch(1, 1);
  auto* title = new QLabel(section.name, widget);
  title->setProperty("role", "section");
  grid->addWidget(title, 0, 0, 1, 2);
  int line = 0;
  for (const Row& row : section.rows) {
    grid->addWidget(makeKeys(row, change), ++line, 0, Qt::AlignLeft);
    grid->addWidget(new QLabel(row.does, widget), line, 1);
  }
  return widget;
}

/// The sections in columns of about the same height; each keeps their order.
std::vector<std::vector<std::size_t>> columnsOf(const std::vector<Section>& sections,
                                                std::size_t count) {
  std::vector<std::size_t> tallestFirst(sections.size());
  std::iota(tallestFirst.begin(), tallestFirst.end(), 0);
  std::ranges::stable_sort(tallestFirst, std::greater(),
                           [&](std::size_t i) { return sections[i].height(); });
  std::vector<std::vector<std::size_t>> columns(count);
  std::vector<std::size_t> heights(count, 0);
  for (const std::size_t i : tallestFirst) {
    const auto lowest = std::ranges::min_element(heights) - heights.begin();
    columns[lowest].push_back(i);
    heights[lowest] += sections[i].height();
  }
  for (std::vector<std::size_t>& column : columns)
    std::ranges::sort(column);
  std::ranges::sort(columns);
  return columns;
}

QHBoxLayout* makeColumns(const std::vector<Section>& sections, std::size_t count,
                         const Change& change, QWidget* parent) {
  auto* columns = new QHBoxLayout;
  columns->setSpacing(24);
  for (const std::vector<std::size_t>& indices : columnsOf(sections, count)) {
    auto* column = new QVBoxLayout;
    column->setSpacing(12);
    for (const std::size_t i : indices)
      column->addWidget(makeSection(sections[i], change, parent));
    column->addStretch(1);
    columns->addLayout(column);
  }
  return columns;
}

} // namespace

ShortcutSheet::ShortcutSheet(KeyBindings& bindings, QWidget* parent)
    : QDialog(parent), bindings_(bindings), scroll_(new QScrollArea) {
  setObjectName("shortcut_sheet");
  setManualPlace(*this, QStringLiteral("window.md#keys-of-your-own"));
  setWindowTitle(tr("Shortcuts"));
  setAttribute(Qt::WA_DeleteOnClose);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  QPushButton* change = buttons->addButton(tr("Change Keys…"), QDialogButtonBox::ActionRole);
  connect(change, &QPushButton::clicked, this, [this] { this->change(nullptr); });
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* page = new QVBoxLayout(this);
  page->setContentsMargins(24, 20, 24, 16);
  page->setSpacing(16);
  scroll_->setWidgetResizable(true);
  scroll_->setFrameShape(QFrame::NoFrame);
  scroll_->setAccessibleName(tr("Shortcuts"));
  page->addWidget(scroll_);
  page->addWidget(buttons);
  connect(&bindings_, &KeyBindings::changed, this, &ShortcutSheet::fill);
  fill();
}

void ShortcutSheet::fill() {
  auto* rows = new QWidget;
  rows->setObjectName("shortcut_rows");
  const Change change = [this](const QAction* action) { this->change(action); };
  const std::vector<Section> sections = sectionsOf(bindings_.actions());
  const QSize room = roomForRows();
  for (std::size_t count = 4; count > 0; --count) { // as many side by side as there is room for
    delete rows->layout();
    qDeleteAll(rows->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly));
    QHBoxLayout* columns = makeColumns(sections, count, change, rows);
    columns->setContentsMargins(0, 0, 0, 0);
    rows->setLayout(columns);
    if (rows->sizeHint().width() <= room.width()) break;
  }
  if (QWidget* last = scroll_->takeWidget()) last->deleteLater(); // a button of it may be clicked
  scroll_->setWidget(rows);
  const int bar = scroll_->verticalScrollBar()->sizeHint().width();
  scroll_->setMinimumSize((rows->sizeHint() + QSize(bar, 0)).boundedTo(room));
}

/// Of the sheet, in the window that it is over, or on the screen.
QSize ShortcutSheet::roomForRows() const {
  const QSize window = parentWidget() != nullptr ? parentWidget()->window()->size()
                                                 : screen()->availableSize() - QSize(16, 48);
  const QMargins margins = layout()->contentsMargins();
  const int foot = layout()->spacing() + 32; // the buttons below
  return window - QSize(margins.left() + margins.right(), margins.top() + margins.bottom() + foot);
}

void ShortcutSheet::change(const QAction* action) {
  auto* dialog = new KeysDialog(bindings_, action, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->open();
}

} // namespace espalier
