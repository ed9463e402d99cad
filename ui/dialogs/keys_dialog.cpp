#include "ui/dialogs/keys_dialog.h"

#include "ui/dialogs/key_bindings.h"
#include "ui/dialogs/key_edit.h"
#include "ui/document/manual_place.h"

#include <QAction>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace espalier {
namespace {

enum Column { commandColumn, keysColumn };

QString nameOf(const QAction& action) {
  return action.property("name").toString();
}

QString shortcutOf(const QAction& action) {
  return QKeySequence::listToString(action.shortcuts(), QKeySequence::NativeText);
}

QPushButton* makeButton(const char* name, const QString& text) {
  auto* button = new QPushButton(text);
  button->setObjectName(name);
  button->setAutoDefault(false); // Enter is a key like others here
  return button;
}

} // namespace

KeysDialog::KeysDialog(KeyBindings& bindings, const QAction* chosen, QWidget* parent)
    : QDialog(parent), bindings_(bindings), filter_(new QLineEdit), list_(new QTreeWidget),
      name_(new QLabel), keys_(new KeyEdit), note_(new QLabel),
      set_(makeButton("set_keys", tr("Set"))), clear_(makeButton("clear_keys", tr("No Keys"))),
      reset_(makeButton("reset_keys", tr("Reset"))),
      resetAll_(makeButton("reset_all_keys", tr("Reset All"))) {
  setObjectName("keys_dialog");
  setManualPlace(*this, QStringLiteral("window.md#keys-of-your-own"));
  setWindowTitle(tr("Change Keys"));
  resize(560, 600);
  makeList();
  auto* page = new QVBoxLayout(this);
  page->setContentsMargins(24, 20, 24, 16);
  page->setSpacing(12);
  page->addWidget(filter_);
  page->addWidget(list_, 1);
  page->addWidget(makeEditor());
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  buttons->button(QDialogButtonBox::Close)->setAutoDefault(false);
  buttons->addButton(resetAll_, QDialogButtonBox::ResetRole);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  page->addWidget(buttons);
  connect(resetAll_, &QPushButton::clicked, &bindings_, &KeyBindings::resetAll);
  connect(&bindings_, &KeyBindings::changed, this, &KeysDialog::refresh);
  refresh();
  choose(chosen);
}

/// Enter presses the button that has the keyboard; none of them is pressed from elsewhere.
void KeysDialog::keyPressEvent(QKeyEvent* event) {
  const bool isEnter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  auto* button = qobject_cast<QPushButton*>(focusWidget());
  if (isEnter && button != nullptr) {
    if (!event->isAutoRepeat()) button->click();
    return;
  }
  QDialog::keyPressEvent(event);
}

void KeysDialog::makeList() {
  filter_->setObjectName("keys_filter");
  filter_->setAccessibleName(tr("Filter of the commands"));
  filter_->setPlaceholderText(tr("Filter by name or keys"));
  filter_->setClearButtonEnabled(true);
  connect(filter_, &QLineEdit::textChanged, this, &KeysDialog::filter);
  list_->setObjectName("keys_list");
  list_->setAccessibleName(tr("Commands and their keys"));
  list_->setHeaderLabels({tr("Command"), tr("Keys")});
  list_->header()->setStretchLastSection(false);
  list_->header()->setSectionResizeMode(commandColumn, QHeaderView::Stretch);
  list_->header()->setSectionResizeMode(keysColumn, QHeaderView::ResizeToContents);
  QTreeWidgetItem* section = nullptr;
  for (const QAction* action : bindings_.actions()) {
    const QString name = action->property("section").toString();
    if (section == nullptr || section->text(commandColumn) != name) {
      section = new QTreeWidgetItem(list_, {name});
      section->setFlags(Qt::ItemIsEnabled);
    }
    auto* item = new QTreeWidgetItem(section, {nameOf(*action)});
    item->setData(commandColumn, Qt::UserRole, action->objectName());
    item->setToolTip(commandColumn, action->statusTip());
  }
  list_->expandAll();
  connect(list_, &QTreeWidget::currentItemChanged, this, &KeysDialog::refreshEditor);
  connect(list_, &QTreeWidget::itemDoubleClicked, keys_, qOverload<>(&QWidget::setFocus));
}

QWidget* KeysDialog::makeEditor() {
  auto* editor = new QWidget;
  auto* column = new QVBoxLayout(editor);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  name_->setProperty("role", "title");
  note_->setObjectName("keys_note");
  note_->setWordWrap(true);
  note_->setProperty("role", "quiet");
  note_->setMinimumHeight(2 * note_->fontMetrics().height());
  note_->setAlignment(Qt::AlignTop);
  keys_->setObjectName("new_keys");
  keys_->setAccessibleName(tr("New keys"));
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  row->addWidget(keys_, 1);
  for (QPushButton* button : {set_, clear_, reset_})
    row->addWidget(button);
  column->addWidget(name_);
  column->addLayout(row);
  column->addWidget(note_);
  connect(keys_, &KeyEdit::keysChanged, this, &KeysDialog::refreshEditor);
  connect(set_, &QPushButton::clicked, this, &KeysDialog::take);
  connect(clear_, &QPushButton::clicked, this, [this] { bindings_.set(*current(), {}); });
  connect(reset_, &QPushButton::clicked, this, [this] { bindings_.reset(*current()); });
  for (const QPushButton* button : {set_, clear_, reset_}) // else it goes on to the next of them
    connect(button, &QPushButton::clicked, list_, qOverload<>(&QWidget::setFocus));
  return editor;
}

void KeysDialog::choose(const QAction* action) {
  for (QTreeWidgetItemIterator at(list_, QTreeWidgetItemIterator::NoChildren); *at != nullptr; ++at)
    if (action == nullptr || (*at)->data(0, Qt::UserRole) == action->objectName()) {
      list_->setCurrentItem(*at);
      list_->scrollToItem(*at, QTreeWidget::PositionAtCenter);
      if (action == nullptr)
        filter_->setFocus(); // none was asked for
      else
        keys_->setFocus();
      return;
    }
}

void KeysDialog::filter(const QString& text) {
  for (int i = 0; i < list_->topLevelItemCount(); ++i) {
    QTreeWidgetItem* section = list_->topLevelItem(i);
    bool isAny = false;
    for (int k = 0; k < section->childCount(); ++k) {
      QTreeWidgetItem* item = section->child(k);
      const bool isFound = item->text(commandColumn).contains(text, Qt::CaseInsensitive) ||
                           item->text(keysColumn).compare(text, Qt::CaseInsensitive) == 0;
      item->setHidden(!isFound);
      isAny = isAny || isFound;
    }
    section->setHidden(!isAny);
  }
}

void KeysDialog::refresh() {
  for (QTreeWidgetItemIterator at(list_, QTreeWidgetItemIterator::NoChildren); *at != nullptr; ++at)
    for (const QAction* action : bindings_.actions()) {
      if ((*at)->data(0, Qt::UserRole) != action->objectName()) continue;
      (*at)->setText(keysColumn, shortcutOf(*action));
      QFont font = list_->font();
      font.setBold(bindings_.isChanged(*action));
      (*at)->setFont(keysColumn, font);
    }
  resetAll_->setEnabled(bindings_.isAnyChanged());
  keys_->setKeys({});
  refreshEditor();
}

/// What Set will do, and to whom.
void KeysDialog::refreshEditor() {
  const QAction* action = current();
  const bool isOpen = action != nullptr && !bindings_.isFixed(*action);
  const QKeySequence keys = keys_->keys();
  const QString text = keys.toString(QKeySequence::NativeText);
  const QAction* other = action != nullptr ? bindings_.holder(keys, *action) : nullptr;
  const bool isTaken = other != nullptr && bindings_.isFixed(*other);
  name_->setText(action != nullptr ? nameOf(*action) : QString());
  keys_->setEnabled(isOpen);
  set_->setEnabled(isOpen && !keys.isEmpty() && !isTaken);
  set_->setText(other != nullptr && !isTaken ? tr("Move Here") : tr("Set"));
  clear_->setEnabled(isOpen && !action->shortcuts().isEmpty());
  reset_->setEnabled(isOpen && bindings_.isChanged(*action));
  if (action != nullptr && !isOpen)
    note_->setText(tr("This key stays as it is"));
  else if (isTaken)
    note_->setText(tr("%1 stays with “%2”: press others").arg(text, nameOf(*other)));
  else if (other != nullptr)
    note_->setText(tr("%1 is used for “%2”, which would lose it").arg(text, nameOf(*other)));
  else
    note_->setText(keys.isEmpty() ? tr("Go to the field and press the new keys") : QString());
}

void KeysDialog::take() {
  bindings_.set(*current(), keys_->keys());
}

QAction* KeysDialog::current() const {
  const QTreeWidgetItem* item = list_->currentItem();
  if (item == nullptr) return nullptr;
  for (QAction* action : bindings_.actions())
    if (item->data(commandColumn, Qt::UserRole) == action->objectName()) return action;
  return nullptr;
}

} // namespace espalier
