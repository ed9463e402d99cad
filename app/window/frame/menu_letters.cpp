#include "app/window/frame/menu_letters.h"

#include <QAction>
#include <QMap>
#include <QMenu>
#include <QSet>
#include <QWidgetAction>

#include <algorithm>

namespace espalier {
namespace {

/// Where the mark of the letter is; -1 if there is none. "&&" is an ampersand.
qsizetype markIn(const QString& text) {
  for (qsizetype i = 0; i + 1 < text.size(); ++i) {
    if (text[i] != '&') continue;
    if (text[i + 1] != '&') return i;
    ++i;
  }
  return -1;
}

/// Where a mark may be set: where it is, then before what words begin with, then before other
/// letters and digits.
QList<qsizetype> placesIn(const QString& text, qsizetype mark) {
  QList<qsizetype> places;
  if (mark >= 0) places.append(mark);
  for (const bool isOfBeginnings : {true, false})
    for (qsizetype i = 0; i < text.size(); ++i) {
      const bool isBeginning = i == 0 || text[i - 1].isSpace();
      if (text[i].isLetterOrNumber() && isBeginning == isOfBeginnings) places.append(i);
    }
  return places;
}

/// Gives as many entries as it can a letter each, by augmenting paths: one that has a letter takes
/// another where one that can have no other needs it.
/// Source: H. W. Kuhn, "The Hungarian method for the assignment problem", 1955.
class Letters {
public:
  void add(QAction* action) {
    QString text = action->text();
    const qsizetype mark = markIn(text);
    if (mark >= 0) text.remove(mark, 1);
    entries_.append({action, text, placesIn(text, mark)});
    QSet<QChar> tried;
    take(entries_.size() - 1, tried);
  }
  void set() const {
    for (qsizetype i = 0; i < entries_.size(); ++i) {
      const Entry& entry = entries_[i];
      const auto place = std::ranges::find_if(entry.places, [&](qsizetype at) {
        return givenTo_.value(entry.text[at].toUpper(), -1) == i;
      });
      QString text = entry.text;
      if (place != entry.places.end()) text.insert(*place, '&');
      entry.action->setText(text);
    }
  }

private:
  struct Entry {
    QAction* action;
    QString text; // without a mark
    QList<qsizetype> places;
  };

  bool take(qsizetype index, QSet<QChar>& tried) {
    for (const bool mayMoveOthers : {false, true})
      for (const qsizetype place : entries_[index].places) {
        const QChar letter = entries_[index].text[place].toUpper();
        const bool isFree = !givenTo_.contains(letter);
        if (tried.contains(letter) || (!isFree && !mayMoveOthers)) continue;
        tried.insert(letter);
        if (!isFree && !take(givenTo_[letter], tried)) continue;
        givenTo_[letter] = index;
        return true;
      }
    return false;
  }

  QList<Entry> entries_;
  QMap<QChar, qsizetype> givenTo_;
};

void giveLettersNow(const QMenu& menu) {
  Letters letters;
  for (const bool areNamed : {true, false}) // those that name a letter get it first
    for (QAction* action : menu.actions()) {
      const bool isTitle = qobject_cast<QWidgetAction*>(action) != nullptr;
      if (action->isSeparator() || isTitle || !action->isVisible()) continue;
      if ((markIn(action->text()) >= 0) == areNamed) letters.add(action);
    }
  letters.set();
}

} // namespace

void giveLetters(QMenu& menu) {
  constexpr const char* hasLetters = "hasLetters";
  if (menu.property(hasLetters).toBool()) return;
  menu.setProperty(hasLetters, true);
  QObject::connect(&menu, &QMenu::aboutToShow, &menu, [&menu] {
    giveLettersNow(menu);
    for (const QAction* action : menu.actions())
      if (action->menu() != nullptr) giveLetters(*action->menu());
  });
}

QString entryText(QString name) {
  return name.replace('&', QStringLiteral("&&"));
}

} // namespace espalier
