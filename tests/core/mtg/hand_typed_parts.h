#pragma once

#include "tests/core/mtg/hand_typed.h"

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace espalier::test {

// What the texts are made of.

[[nodiscard]] std::string replacedAll(std::string text, std::string_view from, std::string_view to);
[[nodiscard]] std::string joined(std::initializer_list<std::string_view> parts);

/// Tabs for arrows, which one sees; without the line end at the beginning.
[[nodiscard]] std::string tabs(const char* text);

// Shoots S are numbered by the node that bears them: S16.2 is the second at node 16.
inline constexpr const char* shoots = R"(
CODE :→FORM-A

CLASSES :
SYMBOL→SCALE→DECOMPOSITION→INDEXATION→DEFINITION
$→0→FREE→FREE→IMPLICIT
P→1→FREE→FREE→EXPLICIT
S→2→FREE→FREE→EXPLICIT
U→3→FREE→FREE→EXPLICIT

DESCRIPTION :
LEFT→RIGHT→RELTYPE→MAX
S→S→+→?
U→U→<→1
U→U→+→?

FEATURES :
NAME→TYPE
Length→REAL
Leaves→INT

MTG :
ENTITY-CODE→→→→Length→Leaves
/P1→→→→250→
→/S1→→→240→
→→/U1→→12.5→8
→→^<U16→→14→9
→→→+S16.1/U1→7→5
→→→^<U2→6.5→4
→→^<U17→→13→
→→→+S17.1/U1→3→2
→→→+S17.2/U1→4→2
→→^<U18→→9→7
)";

inline constexpr const char* blanksAndTabs = R"(
CODE :→FORM-A

CLASSES :
SYMBOL→SCALE→DECOMPOSITION→INDEXATION→DEFINITION
$→0→FREE→FREE→IMPLICIT
P→1→FREE→FREE→EXPLICIT
A→2→<-LINEAR→FREE→EXPLICIT
E→3→FREE→FREE→EXPLICIT

FEATURES :
NAME→TYPE
Length→REAL
Date→DD/MM/YYYY
Remark→ALPHA

MTG :
ENTITY-CODE→→→→Length→Date→Remark
/P1/A1→→→→→12/03/2004→main stem
→/E1→→→3.5→12/03/2004→
→^<E2→→→4→12/03/2004→
→→+A2/E1→→1.5→28/11/2004→
→→^<E2→→1→28/11/2004→dead
→^<E3→→→2→12/03/2004→
)";

// All of them, by where they differ from others.
[[nodiscard]] const std::vector<HandTyped>& dottedTexts();
[[nodiscard]] const std::vector<HandTyped>& headedTexts();
[[nodiscard]] const std::vector<HandTyped>& classedTexts();
[[nodiscard]] const std::vector<HandTyped>& featuredTexts();
[[nodiscard]] const std::vector<HandTyped>& codedTexts();

} // namespace espalier::test
