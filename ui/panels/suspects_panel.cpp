#include "ui/panels/suspects_panel.h"

#include "ui/document/doubt_text.h"
#include "ui/document/plant_document.h"
#include "ui/panels/check_form.h"
#include "ui/panels/focus_keys.h"
#include "ui/panels/label_role.h"
#include "ui/panels/panel_button.h"

#include <QAction>
#include <QComboBox>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QStyleHints>
#include <QTimer>
#include <QToolButton>
#include <QTreeView>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

namespace espalier {

SuspectsPanel::SuspectsPanel(const PlantDocument& document, const Actions& actions,
                             CheckForm& checks, SuspectsModel::TextOf textOf, QWidget* parent)
    : QWidget(parent), document_(document), actions_(actions), checks_(checks),
      model_(new SuspectsModel(std::move(textOf), this)),
      title_(makeLabel("findings_title", "title")),
      agreement_(makeLabel("doubts_agreement", "value")),
      note_(makeLabel("findings_note", "quiet")), question_(makeLabel("doubts_question", "value")),
      asked_(new QWidget), kinds_(new QComboBox), places_(new QComboBox), list_(new QTreeView),
      sentence_(makeLabel("findings_sentence", "quiet")), walk_(new QWidget) {
  setObjectName("findings_panel");
  for (QLabel* label : {title_, agreement_, note_, question_, sentence_}) {
    label->setWordWrap(true);
    label->setMinimumWidth(72);
    label->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
  }
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(8, 12, 10, 12); // at the right room for a scroll bar
  column->setSpacing(8);
  // What comes and goes is below the list: nothing moves under the pointer of who goes through it.
  column->addWidget(title_);
  column->addWidget(sharingButton(*actions.ask));
  makeFilters();
  makeWalk();
  auto* fields = new QVBoxLayout;
  fields->setSpacing(4);
  for (QWidget* field : {static_cast<QWidget*>(kinds_), static_cast<QWidget*>(places_), walk_})
    fields->addWidget(field);
  column->addLayout(fields);
  makeList();
  column->addWidget(list_, 2);
  column->addWidget(makeQuestion());
  column->addWidget(sentence_);
  column->addWidget(note_);
  column->addWidget(agreement_);
  rest_ = sharingButton(*actions.decideRest);
  column->addWidget(rest_);
  column->addWidget(&checks_, 1);
  connect(&checks_, &CheckForm::opened, this, &SuspectsPanel::refreshShown);
  column->addStretch(); // without a list, what there is stays at the top
  show({});
  showAgreement({}, true);
  showNote({});
  showSentence({});
  showQuestion(std::nullopt, false);
}

void SuspectsPanel::makeWalk() {
  walk_->setObjectName("findings_walk");
  auto* walk = new QHBoxLayout(walk_);
  walk->setContentsMargins(0, 0, 0, 0);
  walk->setSpacing(4);
  walk->addWidget(panelButton(*actions_.previous, QStringLiteral("◂")));
  QToolButton* next = panelButton(*actions_.next, QStringLiteral("▸"));
  next->setObjectName("findings_next");
  walk->addWidget(next);
  ignore_ = sharingButton(*actions_.ignore);
  ignore_->setObjectName("findings_ignore");
  walk->addWidget(ignore_, 1);
  connect(actions_.ignore, &QAction::changed, this, &SuspectsPanel::refreshShown);
  connect(this, &SuspectsPanel::currentChanged, this, &SuspectsPanel::refreshShown);
}

QWidget* SuspectsPanel::makeQuestion() {
  auto* asked = new QVBoxLayout(asked_);
  asked->setContentsMargins(0, 0, 0, 0);
  asked->setSpacing(4);
  asked->addWidget(question_);
  for (QAction* answer : actions_.answers) {
    auto* button = new QToolButton; // its text is the answer's, once something is asked
    button->setText(answer->text());
    button->setObjectName(answer->objectName() + "_button");
    button->setProperty("role", "panel");
    button->setMinimumWidth(40);
    button->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    connect(button, &QToolButton::clicked, answer, &QAction::trigger);
    answers_.push_back(button);
    asked->addWidget(button);
  }
  none_ = keyedButton(*actions_.none);
  asked->addWidget(none_);
  auto* row = new QHBoxLayout;
  row->setSpacing(4);
  row->addWidget(sharingButton(*actions_.takeBack, tr("◂ Take Back")));
  row->addWidget(sharingButton(*actions_.skip, tr("Skip ▸")));
  asked->addLayout(row);
  return asked_;
}

void SuspectsPanel::makeFilters() {
  kinds_->setObjectName("findings_kind");
  kinds_->setAccessibleName(tr("Kind that is listed"));
  places_->setObjectName("findings_place");
  places_->setAccessibleName(tr("Part of the plant that is listed"));
  for (const QAction* place : actions_.places)
    places_->addItem(place->iconText());
  for (QComboBox* box : {kinds_, places_}) {
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(6);
    box->setFocusPolicy(Qt::TabFocus); // after a click, Enter goes on meaning what it meant
    opensOnEnter(*box);
  }
  connect(kinds_, &QComboBox::activated, this, [this](int row) {
    emit kindChosen(shownKinds_[static_cast<std::size_t>(row)].kind);
    showFirst();
  });
  connect(places_, &QComboBox::activated, this, [this](int row) {
    actions_.places[static_cast<std::size_t>(row)]->trigger();
    showFirst();
  });
}

void SuspectsPanel::makeList() {
  list_->setObjectName("findings_list");
  list_->setAccessibleName(tr("What may be wrong"));
  list_->setModel(model_);
  list_->setRootIsDecorated(false);
  list_->setUniformRowHeights(true);
  list_->setMinimumWidth(72);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->header()->setStretchLastSection(false);
  list_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  list_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  list_->header()->setResizeContentsPrecision(0); // what is seen
  connect(list_->verticalScrollBar(), &QScrollBar::valueChanged, list_,
          [this] { list_->resizeColumnToContents(1); });
  const auto report = [this] {
    if (const auto row = current()) emit chosen(*row);
  };
  onEnter(*list_, report);
  goesThroughRows(*list_);
  connect(list_, &QTreeView::clicked, this, report);
  connect(list_->selectionModel(), &QItemSelectionModel::currentChanged, this,
          &SuspectsPanel::currentChanged);
}

void SuspectsPanel::show(std::vector<Suspect> suspects) {
  model_->show(std::move(suspects));
  refreshShown();
}

/// The second of two quick clicks may land where an answer has just come up.
void SuspectsPanel::holdAnswers() {
  asked_->setAttribute(Qt::WA_TransparentForMouseEvents);
  QTimer::singleShot(QGuiApplication::styleHints()->mouseDoubleClickInterval(), asked_,
                     [this] { asked_->setAttribute(Qt::WA_TransparentForMouseEvents, false); });
}

/// What is chosen of another list, else what matters most.
void SuspectsPanel::showFirst() {
  if (current())
    list_->scrollTo(list_->currentIndex());
  else
    list_->scrollToTop();
}

/// What is about the list is there with it, and not beside a question.
void SuspectsPanel::refreshShown() {
  const bool isListed = model_->rowCount() > 0;
  const bool isAsked = !asked_->isHidden();
  const bool hasFields = !kinds_->isHidden(); // beside them, an empty list stays in place
  walk_->setVisible(isListed || hasFields);
  list_->setVisible(isListed || hasFields);
  ignore_->setVisible(isListed);
  ignore_->setEnabled(current().has_value()); // its key says what is missing
  // Beside a question one row is enough: its answers stay in sight.
  const int row = std::max(list_->sizeHintForRow(0), 2 * list_->fontMetrics().lineSpacing());
  list_->setMinimumHeight(list_->header()->sizeHint().height() + (isAsked ? 1 : 3) * row +
                          2 * list_->frameWidth());
  sentence_->setVisible(!isAsked && !sentence_->text().isEmpty());
  rest_->setVisible(!isAsked);
  checks_.setVisible(!isAsked || checks_.isOpen());
}

void SuspectsPanel::setCurrent(std::optional<std::size_t> row) {
  const QModelIndex index = row ? model_->index(static_cast<int>(*row), 0) : QModelIndex();
  if (index == list_->currentIndex().siblingAtColumn(0)) return;
  list_->setCurrentIndex(index);
  if (index.isValid()) list_->scrollTo(index);
}

std::optional<std::size_t> SuspectsPanel::current() const {
  const QModelIndex index = list_->currentIndex();
  return index.isValid() ? std::optional(static_cast<std::size_t>(index.row())) : std::nullopt;
}

void SuspectsPanel::showKinds(const std::vector<Kind>& kinds, int chosen) {
  const QSignalBlocker blocker(kinds_);
  if (kinds != shownKinds_) {
    kinds_->clear();
    for (const Kind& kind : kinds)
      kinds_->addItem(kind.text);
    shownKinds_ = kinds;
  }
  for (std::size_t i = 0; i < kinds.size(); ++i)
    if (kinds[i].kind == chosen) kinds_->setCurrentIndex(static_cast<int>(i));
  kinds_->setVisible(kinds.size() > 1);
  places_->setVisible(kinds.size() > 1);
}

void SuspectsPanel::showPlace(std::size_t place) {
  places_->setCurrentIndex(static_cast<int>(place));
}

void SuspectsPanel::showTitle(const QString& text) {
  title_->setText(text);
}

void SuspectsPanel::showNote(const QString& text) {
  note_->setText(text);
  note_->setVisible(!text.isEmpty());
}

void SuspectsPanel::showSentence(const QString& text) {
  sentence_->setText(text);
  refreshShown();
}

void SuspectsPanel::showAgreement(const QString& text, bool isOfNow) {
  agreement_->setText(text);
  agreement_->setEnabled(isOfNow);
  agreement_->setToolTip(isOfNow ? QString()
                                 : tr("Of the plant before the last edits: it is computed anew"));
  agreement_->setVisible(!text.isEmpty());
}

void SuspectsPanel::showQuestion(const std::optional<Doubt>& doubt, bool isByHand) {
  if (doubt && asked_->isHidden()) holdAnswers();
  asked_->setVisible(doubt.has_value());
  none_->setVisible(!isByHand);
  refreshShown();
  QTimer::singleShot(0, list_, [this] { list_->scrollTo(list_->currentIndex()); }); // it has shrunk
  if (!doubt) return;
  question_->setText(isByHand
                         ? tr("Correct it with any tool; %1 goes on")
                               .arg(actions_.skip->shortcut().toString(QKeySequence::NativeText))
                         : questionOf(*doubt, document_.unit()));
  const std::vector<std::size_t> order = numbered(*doubt);
  for (std::size_t i = 0; i < answers_.size(); ++i) {
    const bool isThere = !isByHand && i < order.size();
    answers_[i]->setVisible(isThere);
    if (!isThere) continue;
    const Alternative& one = doubt->alternatives[order[i]];
    answers_[i]->setText(tr("%1  %2 · %3 %")
                             .arg(i + 1)
                             .arg(textOf(*doubt, one))
                             .arg(std::lround(100 * one.probability)));
  }
}

} // namespace espalier
