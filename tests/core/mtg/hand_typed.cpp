// Kinds of MTG texts that are typed by hand, in a spreadsheet or an editor, after what is known of
// such files: indices with a dot, titles, remarks, empty columns, dates, line ends ...
#include "tests/core/mtg/hand_typed_parts.h"

namespace espalier::test {
namespace {

std::string withLineEnds(const char* text, std::string_view end) {
  return replacedAll(tabs(text), "\n", end);
}

/// Empty cells at the end of each line, as a sheet that once was wider leaves them.
std::string withEmptyColumns(const char* text, std::size_t columns) {
  std::string end(columns, '\t');
  end.push_back('\n');
  return replacedAll(tabs(text), "\n", end);
}

} // namespace

std::string replacedAll(std::string text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

std::string joined(std::initializer_list<std::string_view> parts) {
  std::string text;
  for (const std::string_view part : parts)
    text += part;
  return text;
}

std::string tabs(const char* text) {
  return replacedAll(text[0] == '\n' ? text + 1 : text, "→", "\t");
}

const std::vector<HandTyped>& dottedTexts() {
  static const std::vector<HandTyped> texts = {
      {"DotOfAPlace", tabs(shoots), "1,1,4,8\t4\t6"},
      {"DotsOfTwoClasses", tabs(R"(
CODE:→FORM-A
CLASSES:
SYMBOL→SCALE→DECOMPOSITION→INDEXATION→DEFINITION
$→0→FREE→FREE→IMPLICIT
T→1→CONNECTED→FREE→EXPLICIT
B→2→<-LINEAR→FREE→EXPLICIT
S→3→<-LINEAR→FREE→EXPLICIT
DESCRIPTION:
LEFT→RIGHT→RELTYPE→MAX
B→B→+→?
S→S→<→1
S→S→+→?
FEATURES:
NAME→TYPE
Diam→REAL
MTG:
ENTITY-CODE→→→→Diam
/T1→→→→
→/B1→→→55
→→/S1→→40
→→^<S2→→38
→→→+B1.1/S1→21
→→→^<S2→19
→→→+B1.2/S1→22
→→^<S3→→33
)"),
       "1,1,3,6\t3\t4"},
      {"DotsInARange", tabs(R"(
CODE :→FORM-A
CLASSES :
SYMBOL→SCALE→DECOMPOSITION→INDEXATION→DEFINITION
$→0→FREE→FREE→IMPLICIT
P→1→FREE→FREE→EXPLICIT
F→2→FREE→FREE→EXPLICIT
FEATURES :
NAME→TYPE
Fruits→INT
MTG :
ENTITY-CODE→→→Fruits
/P1→→→
→/F3.1<<F3.4→→2
→^<F5→→1
)"),
       "1,1,5\t4\t0"},
      {"DotsWithZeros", replacedAll(tabs(shoots), "S17.", "S17.0"), "1,1,4,8\t4\t6"},
      {"ThreeNumbers", replacedAll(tabs(shoots), "S16.1", "S16.1.3"), "1,1,4,8\t4\t6"},
      {"NumbersWithZeros", replacedAll(replacedAll(tabs(shoots), "U1\t", "U01\t"), "U2", "U02"),
       "1,1,4,8\t4\t6"},
      {"DotOfThePlant", replacedAll(tabs(shoots), "/P1", "/P12.104"), "1,1,4,8\t4\t6"},
      {"DotsInFullNames", tabs(R"(
CODE :→FORM-A
CLASSES :
SYMBOL→SCALE→DECOMPOSITION→INDEXATION→DEFINITION
$→0→FREE→FREE→IMPLICIT
P→1→FREE→FREE→EXPLICIT
A→2→FREE→FREE→EXPLICIT
E→3→FREE→FREE→EXPLICIT
FEATURES :
NAME→TYPE
Length→INT
MTG :
ENTITY-CODE→Length
/P1/A1/E16.1→12
/P1/A1/E16.1<E17→11
/P1/A1/E16.1+A16.1/E1→5
/P1/A1/E16.1+A16.2/E1→4
)"),
       "1,1,3,4\t1\t4"},
      {"DotWithinAClassOfDigits", tabs(R"(
CODE :→FORM-A
CLASSES :
SYMBOL→SCALE→DECOMPOSITION→INDEXATION→DEFINITION
$→0→FREE→FREE→IMPLICIT
P→1→FREE→FREE→EXPLICIT
GU2→2→FREE→FREE→EXPLICIT
FEATURES :
NAME→TYPE
Nodes→INT
MTG :
ENTITY-CODE→→Nodes
/P1/GU21.1→→7
→+GU21.2→6
)"),
       "1,1,2\t0\t1"}};
  return texts;
}

const std::vector<HandTyped>& headedTexts() {
  static const std::vector<HandTyped> texts = {
      {"CommentAsTitle",
       joined({"#Pommier Melgueil Braeburn 13\t\t\t\t\n\t\t\t\t\n", tabs(blanksAndTabs)}),
       "1,1,2,5\t3\t2"},
      {"TitleLines",
       joined({"Apple trees, orchard B, row 7\t\t\t\nmeasured 2004-2006: all shoots of more than 5 "
               "cm\n"
               "Code by hand\n\n",
               tabs(blanksAndTabs)}),
       "1,1,2,5\t3\t2"},
      {"TitleThatNamesTheCode",
       joined({"CODES OF BRANCHES: see page 3\nMTG\n", tabs(blanksAndTabs)}), "1,1,2,5\t3\t2"},
      {"BlanksAroundTheColon",
       replacedAll(tabs(blanksAndTabs), "CODE :\tFORM-A", "CODE  : FORM-A \t\t\t"),
       "1,1,2,5\t3\t2"},
      {"NoBlankAtTheColon",
       replacedAll(replacedAll(tabs(blanksAndTabs), " :\n", ":\n"), "CODE :\t", "CODE:"),
       "1,1,2,5\t3\t2"},
      {"SmallLetters", tabs(R"(
Code : Form-A
Classes :
Symbol→Scale→Decomposition→Indexation→Definition
P→1→free→free→explicit
N→2→free→free→explicit
Description :
Left→Right→Reltype→Max
N→N→<→1
Features :
Name→Type
Length→real
Leaves→Int
Remark→alpha
Mtg :
Entity-Code→→Length→Leaves→Remark
/P1→→→→first tree
→/N1→1.25→3→
→^<N2→1.5→→none
)"),
       "1,1,2\t1\t0"},
      {"EmptyColumnsAtTheEnd", withEmptyColumns(blanksAndTabs, 36), "1,1,2,5\t3\t2"},
      {"LineEndsOfWindows", withLineEnds(blanksAndTabs, "\r\n"), "1,1,2,5\t3\t2"},
      {"LineEndsOfOldMacs", withLineEnds(blanksAndTabs, "\r"), "1,1,2,5\t3\t2"},
      {"ByteOrderMark", joined({"\xEF\xBB\xBF", tabs(blanksAndTabs)}), "1,1,2,5\t3\t2"},
      {"ByteOrderMarkBeforeATitle", joined({"\xEF\xBB\xBFVerger 3\n", tabs(blanksAndTabs)}),
       "1,1,2,5\t3\t2"},
      {"Latin1", replacedAll(tabs(blanksAndTabs), "main stem", "axe de ch\xEAne bris\xE9"),
       "1,1,2,5\t3\t2", 1},
      {"NamesWithAccents", replacedAll(tabs(blanksAndTabs), "Remark", "Développement"),
       "1,1,2,5\t3\t2"},
      {"EndSignOfDos", joined({withLineEnds(blanksAndTabs, "\r\n"), "\x1A"}), "1,1,2,5\t3\t2"},
      {"NoLineEndAtTheEnd", tabs(blanksAndTabs).substr(0, tabs(blanksAndTabs).size() - 1),
       "1,1,2,5\t3\t2"},
      {"SectionsWithoutColon",
       replacedAll(replacedAll(tabs(blanksAndTabs), "CLASSES :", "CLASSES"), "MTG :", "MTG"),
       "1,1,2,5\t3\t2"},
      {"NoLineMtg", replacedAll(tabs(blanksAndTabs), "MTG :\n", ""), "1,1,2,5\t3\t2", 1},
      {"Topo", replacedAll(tabs(blanksAndTabs), "ENTITY-CODE", "TOPO"), "1,1,2,5\t3\t2"}};
  return texts;
}

const std::vector<HandTyped>& handTypedTexts() {
  static const std::vector<HandTyped> texts = [] {
    std::vector<HandTyped> all;
    for (const auto& part :
         {dottedTexts(), headedTexts(), classedTexts(), featuredTexts(), codedTexts()})
      all.insert(all.end(), part.begin(), part.end());
    return all;
  }();
  return texts;
}

} // namespace espalier::test
