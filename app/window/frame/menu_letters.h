#pragma once

#include <QString>

class QMenu;

namespace espalier {

/// Gives each entry of a menu a letter of its own that chooses it, as in "&Open", each time before
/// the menu is shown, and each menu within: an entry keeps the letter that its text names, unless
/// one above has it or another can have no other; as many others as can get one, rather that of a
/// word's beginning.
void giveLetters(QMenu& menu);

/// A name, such as of a file, as the text of an entry that shows each "&" of it.
[[nodiscard]] QString entryText(QString name);

} // namespace espalier
