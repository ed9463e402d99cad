#include "core/io/bytes/xml.h"
#include "tests/core/io/samples.h"

#include <gmock/gmock.h>
#include <sstream>

namespace espalier {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string refusalOfXml(const std::string& text) {
  return test::errorOf([&] { return XmlFile(text, "oak.xml", "oak").root().name(); });
}

std::string nested(int depth) {
  std::string text = "<oak>";
  for (int i = 1; i < depth; ++i)
    text += "<a>";
  for (int i = 1; i < depth; ++i)
    text += "</a>";
  return text + "</oak>";
}

TEST(XmlFile, NamesTheLineWhereItIsBroken) {
  EXPECT_THAT(refusalOfXml("<oak>\n<a>\n</b>\n</oak>"),
              StartsWith("oak.xml, line 3: the XML is broken"));
  EXPECT_THAT(refusalOfXml("<oak>\n<a>\n"), HasSubstr("the XML is broken"));
  EXPECT_THAT(refusalOfXml("no XML at all"), HasSubstr("the XML is broken"));
  EXPECT_EQ(refusalOfXml("\n<elm/>"), "oak.xml, line 2: expected an element 'oak', found 'elm'");
}

TEST(XmlFile, ReturnsTheLineOfAnElement) {
  const XmlFile xml("<?xml version=\"1.0\"?>\n<oak>\n\n  <a/></oak>", "oak.xml", "oak");
  EXPECT_EQ(inEnglish(xml.where(xml.root().child("a"))), "oak.xml, line 4");
}

TEST(XmlFile, ReadsFiniteNumbersOnly) {
  const XmlFile xml("<oak>\n<a>1.5</a><a>nan</a><a>two</a><a/></oak>", "oak.xml", "oak");
  std::vector<std::string> outcomes;
  for (const pugi::xml_node node : xml.root().children("a"))
    outcomes.push_back(test::errorOf([&] { return xml.numberIn(node, node.child_value(), "x"); }));
  EXPECT_THAT(outcomes,
              testing::ElementsAre("", "oak.xml, line 2: expected a number as x, found 'nan'",
                                   "oak.xml, line 2: expected a number as x, found 'two'",
                                   "oak.xml, line 2: expected a number as x, found ''"));
}

TEST(XmlFile, RefusesDocumentsThatDefineEntities) {
  const std::string laughs = "<?xml version=\"1.0\"?>\n<!DOCTYPE oak [\n<!ENTITY a \"ha\">\n"
                             "<!ENTITY b \"&a;&a;&a;&a;&a;&a;&a;&a;&a;&a;\">\n]>\n<oak>&b;</oak>";
  EXPECT_THAT(refusalOfXml(laughs), HasSubstr("the document defines entities, which are not read"));
  const std::string outside =
      "<!DOCTYPE oak [<!ENTITY a SYSTEM \"file:///etc/hostname\">]><oak>&a;</oak>";
  EXPECT_THAT(refusalOfXml(outside), HasSubstr("the document defines entities"));
}

TEST(XmlFile, TakesADocumentTypeWithoutEntities) {
  EXPECT_EQ(refusalOfXml("<!DOCTYPE oak SYSTEM \"oak.dtd\"><oak/>"), "");
}

TEST(XmlFile, RefusesElementsNestedDeeperThanAnyPlant) {
  EXPECT_EQ(refusalOfXml(nested(100'000)), "");
  EXPECT_EQ(refusalOfXml(nested(100'001)),
            "oak.xml, line 1: its elements are nested over 100000 deep, as in no plant");
}

TEST(IsXml, LooksAtTheOutermostElement) {
  EXPECT_TRUE(isXml(
      "\xEF\xBB\xBF<?xml version='1.0'?>\n<!-- a <b> -->\n<!DOCTYPE oak>\n<oak a='1'>", "oak"));
  EXPECT_TRUE(isXml("<oak/>", "oak"));
  EXPECT_FALSE(isXml("<oaks>", "oak"));
  EXPECT_FALSE(isXml("<elm><oak>", "oak"));
  EXPECT_FALSE(isXml("<oak", "oak"));
  EXPECT_FALSE(isXml("<!-- <oak>", "oak"));
  EXPECT_FALSE(isXml("", "oak"));
}

/// An `oak` with this text and attribute, written.
std::string written(const std::string& text) {
  pugi::xml_document document;
  pugi::xml_node oak = document.append_child("oak");
  addAttribute(oak, "name", text);
  addText(oak, "note", text);
  std::ostringstream out;
  writeXml(out, document);
  return out.str();
}

void expectBack(const std::string& text, const std::string& expected) {
  const XmlFile xml(written(text), "oak.xml", "oak");
  EXPECT_EQ(xml.root().attribute("name").value(), expected) << written(text);
  EXPECT_EQ(xml.root().child_value("note"), expected) << written(text);
}

TEST(WriteXml, DeclaresUtf8AndWritesAnElementALine) {
  EXPECT_EQ(written("a<b>"), "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                             "<oak name=\"a&lt;b>\">\n<note>a&lt;b&gt;</note>\n</oak>\n");
}

TEST(WriteXml, AndReadingGivesAnyTextBack) {
  for (const std::string text :
       {"a<b> & \"c\" 'd' &amp; ]]> <!-- -->", "Lärche 落叶松 🌲", "%s \\ `", "&#65;", "a \x7F"})
    expectBack(text, text);
  expectBack("", "");
}

TEST(WriteXml, WritesBlanksForWhatXmlCannotHold) {
  expectBack(std::string("a\0b\x01\x1F\t\n\r c", 10), "a b      c");
}

TEST(WriteXml, NestsAsDeepAsPlantsAreTall) {
  pugi::xml_document document;
  pugi::xml_node deepest = document.append_child("oak");
  for (int i = 1; i < 100'000; ++i)
    deepest = deepest.append_child("a");
  std::ostringstream out;
  writeXml(out, document);
  EXPECT_LT(out.str().size(), 1'000'000U);
  EXPECT_EQ(refusalOfXml(out.str()), "");
}

} // namespace
} // namespace espalier
