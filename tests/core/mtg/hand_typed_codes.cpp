// Texts whose codes are typed in other ways, and texts that are refused.
#include "tests/core/mtg/hand_typed_parts.h"

namespace espalier::test {

const std::vector<HandTyped>& codedTexts() {
  static const std::vector<HandTyped> texts = {
      {"ColumnsOfBranches", tabs(blanksAndTabs), "1,1,2,5\t3\t2"},
      {"NoSignOfTheColumn", tabs(R"(
CODE :→FORM-A
CLASSES :
SYMBOL→SCALE→DECOMPOSITION→INDEXATION→DEFINITION
$→0→FREE→FREE→IMPLICIT
P→1→FREE→FREE→EXPLICIT
N→2→FREE→FREE→EXPLICIT
FEATURES :
NAME→TYPE
d→INT
MTG :
ENTITY-CODE→→→d
/P1→→→
→/N1→→9
→<N2→→8
→→+N1→3
→→<N2→2
→<N3→→7
)"),
       "1,1,5\t3\t1", 1},
      {"SeveralInALine", tabs(R"(
CODE :→FORM-A
CLASSES :
SYMBOL→SCALE→DECOMPOSITION→INDEXATION→DEFINITION
$→0→FREE→FREE→IMPLICIT
P→1→FREE→FREE→EXPLICIT
A→2→FREE→FREE→EXPLICIT
U→3→FREE→FREE→EXPLICIT
FEATURES :
NAME→TYPE
d→INT
MTG :
ENTITY-CODE→→→d
/P1/A1/U1<U2→→→12
→+A2/U1<U2<U3→→5
→→+A3/U1→2
^<U3<U4→→→10
)"),
       "1,1,3,8\t5\t4"},
      {"Ranges", tabs(R"(
CODE :→FORM-A
CLASSES :
SYMBOL→SCALE→DECOMPOSITION→INDEXATION→DEFINITION
$→0→FREE→FREE→IMPLICIT
P→1→FREE→FREE→EXPLICIT
U→2→FREE→FREE→EXPLICIT
FEATURES :
NAME→TYPE
d→INT
MTG :
ENTITY-CODE→→→d
/P1/U1<<U10→→→12
→+U1<.<U3→→4
^<U11→→→9
→+U1++U3→→
)"),
       "1,1,17\t12\t4"},
      {"LaterDates", tabs(R"(
CODE :→FORM-A
CLASSES :
SYMBOL→SCALE→DECOMPOSITION→INDEXATION→DEFINITION
$→0→FREE→FREE→IMPLICIT
P→1→FREE→FREE→EXPLICIT
U→2→FREE→FREE→EXPLICIT
FEATURES :
NAME→TYPE
Date→DD/MM/YYYY
Length→REAL
MTG :
ENTITY-CODE→→Date→Length
/P1→→→
→/U1→16/07/2007→2
→*→31/12/2007→3.5
→*→01/12/2008→3.9
→^<U2→31/12/2007→1
→*→01/12/2008→1.5
)"),
       "1,1,2\t1\t0"},
      {"Aliases", tabs(R"(
CODE :→FORM-A
CLASSES :
SYMBOL→SCALE→DECOMPOSITION→INDEXATION→DEFINITION
$→0→FREE→FREE→IMPLICIT
P→1→FREE→FREE→EXPLICIT
U→2→FREE→FREE→EXPLICIT
FEATURES :
NAME→TYPE
Alias→ALPHA
Length→REAL
MTG :
ENTITY-CODE→→Alias→Length
/P1→→→
→/U1→stem→2
→^<U2→→3
(stem)+U1→→→4
)"),
       "1,1,3\t1\t1"},
      {"CommentsOfJulia",
       replacedAll(replacedAll(tabs(blanksAndTabs), "\t\t+A2/E1\t\t1.5",
                               "; the lowest branch\n\t\t+A2/E1\t; broken\t1.5"),
                   "MTG :", "; vertices\nMTG :"),
       "1,1,2,5\t3\t2"},
      {"CommentsOverLines",
       replacedAll(tabs(blanksAndTabs), "\t\t+A2/E1",
                   "(# seen from\nthe south #)\n\t\t+A2/E1 (# here #)"),
       "1,1,2,5\t3\t2"},
      {"CommentsOfExcel",
       replacedAll(tabs(blanksAndTabs), "\t^<E2\t\t\t4",
                   "\"# second year, wet\"\t\t\n\t^<E2\t\"# long, thin\"\t\t4"),
       "1,1,2,5\t3\t2"},
      {"CommentsBetweenLines",
       replacedAll(replacedAll(tabs(blanksAndTabs), "\t^<E3", "# top\n\n\t\t\t\n   \n\t^<E3"),
                   "\t\t^<E2", "\t\t# dead at last\n\t\t^<E2"),
       "1,1,2,5\t3\t2"},
      {"BlanksInCodes",
       replacedAll(replacedAll(tabs(blanksAndTabs), "/P1/A1", " /P1 /A1"), "\t^<E3", "\t ^ < E3 "),
       "1,1,2,5\t3\t2"},
      {"SeveralPlants",
       joined({tabs(blanksAndTabs), tabs("\n/P2/A1→→→→→13/03/2004→\n→/E1→→→7→13/03/2004→\n"
                                         "/P3/A1→→→→→14/03/2004→\n→/E1→→→6→14/03/2004→\n")}),
       "1,3,4,7\t3\t2"},
      {"FirstColumnGoesOn", tabs(R"(
CODE :→FORM-A
CLASSES :
SYMBOL→SCALE→DECOMPOSITION→INDEXATION→DEFINITION
$→0→FREE→FREE→IMPLICIT
P→1→FREE→FREE→EXPLICIT
A→2→FREE→FREE→EXPLICIT
U→3→FREE→FREE→EXPLICIT
FEATURES :
NAME→TYPE
d→INT
MTG :
ENTITY-CODE→→→d
/P1→→→
^/A1→→→
^/U1→→→9
^<U2→→→8
→+A2→→
→^/U1→→3
^<U3→→→7
)"),
       "1,1,2,4\t2\t2"},
      {"ManyColumns",
       tabs("CODE :→FORM-A\nCLASSES :\nSYMBOL→SCALE→DECOMPOSITION→INDEXATION→DEFINITION\n"
            "$→0→FREE→FREE→IMPLICIT\nP→1→FREE→FREE→EXPLICIT\nU→2→FREE→FREE→EXPLICIT\n"
            "FEATURES :\nNAME→TYPE\nd→INT\nMTG :\n"
            "ENTITY-CODE→→→→→→→→→→→→→→→→→→→→d\n/P1\n→/U1→→→→→→→→→→→→→→→→→→→9\n→→+U1\n→→→+U1\n"
            "→→→→+U1→→→→→→→→→→→→→→→→2\n→^<U2→→→→→→→→→→→→→→→→→→→8\n"),
       "1,1,5\t1\t3"}};
  return texts;
}

const std::vector<Doubtful>& doubtfulTexts() {
  static const std::vector<Doubtful> texts = {
      {"DotWithoutNumber", replacedAll(tabs(shoots), "S16.1", "S16."),
       "plant.mtg, line 27, column 4: the index in 'S16.' has a dot without a number on both "
       "sides: "
       "type it as in U16 or U16.1"},
      {"LabelWithAHyphen", replacedAll(tabs(shoots), "S16.1", "S16-1"),
       "plant.mtg, line 27, column 4: 'S16-1' begins with no symbol of the section CLASSES "
       "('$, P, S, U'): type one of these, and behind it its index, as in U1 or S16.1"},
      {"DecimalComma", replacedAll(tabs(shoots), "12.5", "12,5"),
       "plant.mtg, line 25, column 5: Length is '12,5', expected a number with a decimal point, "
       "not "
       "a comma"},
      {"ColumnsPartedByBlanks",
       replacedAll(tabs(shoots), "ENTITY-CODE\t\t\t\tLength\tLeaves",
                   "ENTITY-CODE    Length Leaves"),
       "plant.mtg, line 22: the columns are parted by blanks: put tabs between them"},
      {"NoCode", replacedAll(tabs(shoots), "CODE :\tFORM-A\n", ""),
       "plant.mtg, line 2: the section CLASSES stands before 'CODE : FORM-A': put that line at the "
       "top"},
      {"TwoBytesPerCharacter",
       std::string("\xFF\xFE"
                   "C\0O\0D\0E\0",
                   10),
       "plant.mtg: is text of two bytes per character (UTF-16, \"Unicode Text\" in Excel), which "
       "cannot be read: save it as UTF-8, or in Excel as \"Text (Tab delimited)\""},
      {"TwoBytesWithoutMark", std::string("\0C\0O\0D\0E\0 \0:\0 \0F", 16),
       "plant.mtg: is text of two bytes per character (UTF-16, \"Unicode Text\" in Excel), which "
       "cannot be read: save it as UTF-8, or in Excel as \"Text (Tab delimited)\""},
      {"CodeTooFarRight", replacedAll(tabs(shoots), "\t\t\t^<U2", "\t\t\t\t^<U2"),
       "plant.mtg, line 28, column 5: the code '^<U2' stands among the columns of values: move it "
       "to the left, or these to the right"},
      {"ScaleThatIsNoNumber", replacedAll(tabs(shoots), "S\t2", "S\tsecond"),
       "plant.mtg, line 7: expected the scale of 'S', a number from 0 to 100, found 'second'"}};
  return texts;
}

} // namespace espalier::test
