#pragma once

#include <QString>

namespace espalier {

class ActionSet;

/// A hint with the keys of actions in place of their ids in braces: "{new_child} new child" becomes
/// "N new child". Hints are parted by three spaces; one that names an action without a key is left
/// out. pre: there is an action of each id
[[nodiscard]] QString withKeys(const QString& hint, const ActionSet& actions);

} // namespace espalier
