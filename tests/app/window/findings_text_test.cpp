#include "app/window/review/findings_text.h"
#include "core/base/error.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

using Kind = Finding::Kind;

TEST(FindingsText, ComesBackAsItWas) {
  const std::vector<Finding> findings = {
      {.kind = Kind::crossing, .node = NodeId{12}, .others = {NodeId{57}}},
      {.kind = Kind::unexplainedPoints, .node = NodeId{4}, .place = {1, 2.5, -3}, .reach = 0.25},
      {.kind = Kind::noLength, .node = NodeId{4294967295U}}};
  EXPECT_EQ(findingsFrom(textOf(findings)), findings);
  EXPECT_EQ(textOf(std::vector<Finding>()), "");
  EXPECT_TRUE(findingsFrom("").empty());
}

TEST(FindingsText, IsRefusedIfItIsNone) {
  for (const char* text :
       {"{}", "nonsense", "[1]", R"([{"kind": "no_length", "nodes": []}])",
        R"([{"kind": "unheard_of", "nodes": [1]}])", R"([{"kind": "no_length", "nodes": [-1]}])",
        R"([{"kind": "no_length", "nodes": ["a"]}])", R"([{"kind": "no_length", "nodes": [1e10]}])",
        R"([{"kind": "unexplained_points", "nodes": [1], "place": [1, 2], "reach": 1}])",
        R"([{"kind": "unexplained_points", "nodes": [1], "place": [1, 2, 3]}])"})
    EXPECT_THROW(static_cast<void>(findingsFrom(text)), Error) << text;
}

TEST(LimitsText, ComesBackAsItWas) {
  const std::map<std::string, double> limits = {{"cluster_size", 12}, {"sharp_turn", 62.5}};
  EXPECT_EQ(limitsFrom(textOf(limits)), limits);
  EXPECT_EQ(textOf(std::map<std::string, double>()), "");
  EXPECT_TRUE(limitsFrom("").empty());
}

TEST(LimitsText, IsRefusedIfItIsNone) {
  for (const char* text :
       {"[]", "nonsense", R"({"sharp_turn": "wide"})", R"({"sharp_turn": null})"})
    EXPECT_THROW(static_cast<void>(limitsFrom(text)), Error) << text;
}

} // namespace
} // namespace espalier
