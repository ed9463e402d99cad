// Texts whose sections before the vertices are typed in other ways.
#include "tests/core/mtg/hand_typed_parts.h"

namespace espalier::test {

const std::vector<HandTyped>& classedTexts() {
  static const std::vector<HandTyped> texts = {
      {"DefinitionsWithComments",
       replacedAll(replacedAll(tabs(blanksAndTabs), "P\t1\tFREE\tFREE\tEXPLICIT",
                               "P\t1\tFREE\tFREE\tIMPLICIT # never measured"),
                   "E\t3\tFREE\tFREE\tEXPLICIT",
                   "E\t3\tFREE\tFREE\tEXPLICIT\t(# internodes,\nnot leaves #)"),
       "1,1,2,5\t3\t2"},
      {"RemarksBehindTheDefinition",
       replacedAll(tabs(blanksAndTabs), "E\t3\tFREE\tFREE\tEXPLICIT",
                   "E\t3\tFREE\tFREE\tEXPLICIT\tinternode\t\t"),
       "1,1,2,5\t3\t2"},
      {"AllDecompositions", tabs(R"(
CODE :→FORM-A
CLASSES :
SYMBOL→SCALE→DECOMPOSITION→INDEXATION→DEFINITION
$ →0 →FREE→FREE→IMPLICIT
P →1 →CONNECTED→FREE→EXPLICIT
A →2 →<-LINEAR→CONSECUTIVE→EXPLICIT
R →2 →+-LINEAR→CONSECUTIVE→EXPLICIT
U →3 →PURELINEAR→FREE→EXPLICIT
I →3 →NOTCONNECTED→FREE→EXPLICIT
E →4 →LINEAR→FREE→EXPLICIT
C →4 →NONE→FREE→IMPLICIT
DESCRIPTION :
LEFT→RIGHT→RELTYPE→MAX
A→A→+→?
U→U,I→<→1
I→U,I→+→10
E→E,C→<→1
FEATURES :
NAME→TYPE
nbEl→INT
MTG :
ENTITY-CODE→→→→nbEl
/P1/A1→→→→
→/U1→→→12
→→/E1→→
→→^<C2→→
→^<I2→→→3
→→+R1/U1→→2
)"),
       "1,1,2,3,2\t2\t2"},
      {"SymbolsAndScalesAlone",
       replacedAll(replacedAll(tabs(blanksAndTabs), "\tFREE\tFREE\tEXPLICIT", ""),
                   "\t<-LINEAR\tFREE\tEXPLICIT", ""),
       "1,1,2,5\t3\t2"},
      {"ClassesPartedByBlanks",
       replacedAll(replacedAll(replacedAll(tabs(blanksAndTabs), "P\t1\tFREE\tFREE\tEXPLICIT",
                                           "P   1   FREE FREE EXPLICIT"),
                               "A\t2\t<-LINEAR", "A   2\t<-LINEAR"),
                   "$\t0\tFREE", "$ 0\tFREE"),
       "1,1,2,5\t3\t2"},
      {"NoHeadings",
       replacedAll(replacedAll(tabs(blanksAndTabs),
                               "SYMBOL\tSCALE\tDECOMPOSITION\tINDEXATION\tDEFINITION\n", ""),
                   "NAME\tTYPE\n", ""),
       "1,1,2,5\t3\t2"},
      {"FinestClassFirst",
       replacedAll(replacedAll(tabs(blanksAndTabs), "$\t0\tFREE\tFREE\tIMPLICIT\n", ""),
                   "P\t1\tFREE\tFREE\tEXPLICIT\nA\t2\t<-LINEAR\tFREE\tEXPLICIT\n"
                   "E\t3\tFREE\tFREE\tEXPLICIT\n",
                   "E\t3\tFREE\tFREE\tEXPLICIT\nA\t2\t<-LINEAR\tFREE\tEXPLICIT\n"
                   "P\t1\tFREE\tFREE\tEXPLICIT\n"),
       "1,1,2,5\t3\t2"},
      {"ListsInRight", tabs(R"(
CODE :→FORM-A
CLASSES :
SYMBOL→SCALE→DECOMPOSITION→INDEXATION→DEFINITION
$→0→FREE→FREE→IMPLICIT
P→1→FREE→FREE→EXPLICIT
U→2→FREE→FREE→EXPLICIT
W→2→FREE→FREE→EXPLICIT
B→2→FREE→FREE→EXPLICIT
DESCRIPTION :
LEFT→RIGHT→RELTYPE→MAX
U→U,W,B→+→?
U→U, W, B→<→1
W→"U,B"→+→?
W U, B < 1
B →B → + →?
FEATURES :
NAME→TYPE
dist→INT
MTG :
ENTITY-CODE→→→dist
/P1→→→
→/U1→→
→^<W2→→12
→→+B1→3
→^<B3→→
)"),
       "1,1,4\t2\t1"},
      {"EmptyDescription",
       replacedAll(tabs(blanksAndTabs),
                   "FEATURES :", "DESCRIPTION :\nLEFT\tRIGHT\tRELTYPE\tMAX\n\t\t\t\n\nFEATURES :"),
       "1,1,2,5\t3\t2"},
      {"NoFeatures", tabs(R"(
CODE :→FORM-A
CLASSES :
SYMBOL→SCALE→DECOMPOSITION→INDEXATION→DEFINITION
$→0→FREE→FREE→IMPLICIT
P→1→FREE→FREE→EXPLICIT
I→2→FREE→FREE→EXPLICIT
MTG :
ENTITY-CODE→→→
/P1→→→
→/I1→→
→^<I2→→
→→+I1→
)"),
       "1,1,3\t1\t1"},
      {"ClassThatIsNotListed", replacedAll(tabs(blanksAndTabs), "\t\t^<E2\t\t1", "\t\t^<Bud\t\t1"),
       "1,1,2,5\t3\t2", 1}};
  return texts;
}

const std::vector<HandTyped>& featuredTexts() {
  static const std::vector<HandTyped> texts = {
      {"RemarksInTheTypeColumn",
       replacedAll(
           replacedAll(tabs(blanksAndTabs), "Length\tREAL", "Length\tREAL (cm, with a ruler)"),
           "Remark\tALPHA", "Remark\tAlpha : what one saw"),
       "1,1,2,5\t3\t2"},
      {"CommentsInTheTypeColumn",
       replacedAll(replacedAll(tabs(blanksAndTabs), "Length\tREAL", "Length\tREAL # cm"),
                   "Remark\tALPHA", "Remark\tALPHA\t# what one saw, when it was dead"),
       "1,1,2,5\t3\t2"},
      {"FeatureWithoutType", replacedAll(tabs(blanksAndTabs), "Remark\tALPHA", "Remark"),
       "1,1,2,5\t3\t2", 1},
      {"TypeThatNobodyKnows",
       replacedAll(tabs(blanksAndTabs), "Remark\tALPHA", "Remark\tD dead, A alive"),
       "1,1,2,5\t3\t2"},
      {"GapsBetweenFeatures",
       replacedAll(replacedAll(replacedAll(tabs(blanksAndTabs), "Length\tDate", "Length\t\t\tDate"),
                               "\t12/03", "\t\t\t12/03"),
                   "\t28/11", "\t\t\t28/11"),
       "1,1,2,5\t3\t2"},
      {"FeatureWithAColumnAlone", replacedAll(tabs(blanksAndTabs), "Date\tDD/MM/YYYY\n", ""),
       "1,1,2,5\t3\t2", 1},
      {"FeatureWithoutColumn",
       replacedAll(tabs(blanksAndTabs), "Remark\tALPHA\n", "Remark\tALPHA\nColor\tSTRING\n"),
       "1,1,2,5\t3\t2"},
      {"DatesOfEveryKind", tabs(R"(
CODE :→FORM-A
CLASSES :
SYMBOL→SCALE→DECOMPOSITION→INDEXATION→DEFINITION
$→0→FREE→FREE→IMPLICIT
P→1→FREE→FREE→EXPLICIT
U→2→FREE→FREE→EXPLICIT
FEATURES :
NAME→TYPE
seen→DD/MM/YYYY
born→DD/MM/YY
flower→DD/MM
planted→MM/YY
fall→DD/MM-TIME
cut→DD/MM/YY-TIME
MTG :
ENTITY-CODE→→seen→born→flower→planted→fall→cut
/P1→→12/03/2004→→→11/98→→
→/U1→12/03/2004→01/04/99→15/04→→02/11-14:30→
→^<U2→12/03/2004→5/4/00→16/4→→→31/12/04-08:00
)"),
       "1,1,2\t1\t0"},
      {"CommasAndSignsInTexts",
       replacedAll(replacedAll(tabs(blanksAndTabs), "main stem", "12,5 cm (estimated) +/- 1"),
                   "dead", "\"cut, 2003\""),
       "1,1,2,5\t3\t2"},
      {"MissingValues",
       replacedAll(replacedAll(tabs(blanksAndTabs), "\t3.5\t", "\tNA\t"), "\t1.5\t", "\tNone\t"),
       "1,1,2,5\t3\t2"},
      {"SpellingsOfNumbers",
       replacedAll(replacedAll(tabs(blanksAndTabs), "\t3.5\t", "\t +3.50\t"), "\t1.5\t",
                   "\t1.5e+01 \t"),
       "1,1,2,5\t3\t2"},
      {"Digitized", tabs(R"(
CODE :→FORM-A
CLASSES :
SYMBOL→SCALE→DECOMPOSITION→INDEXATION→DEFINITION
$→0→FREE→FREE→IMPLICIT
P→1→FREE→FREE→EXPLICIT
B→2→FREE→FREE→EXPLICIT
S→3→FREE→FREE→EXPLICIT
FEATURES :
NAME→TYPE
XX→REAL (cm)
YY→REAL
ZZ→REAL
TopDia→INT→# mm
MTG :
ENTITY-CODE→→→→XX→YY→ZZ→TopDia→→→
/P1→→→→→→→→→→
→/B1→→→→→→55→→→
→→/S1→→0→0→10.5→50→→→# foot
→→^<S2→→0.5→0→20→45→→→
→→→+B2.1/S1→5→1→24→20→→→
→→→+B2.2/S1→-5→1→25→21→→→
→→^<S3→→1→0→31→40→→→
)"),
       "1,1,3,5\t2\t4"}};
  return texts;
}

} // namespace espalier::test
