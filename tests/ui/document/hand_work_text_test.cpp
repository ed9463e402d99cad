#include "ui/document/hand_work_text.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

constexpr std::int64_t minute = 60'000; // [ms]

TEST(HandWorkText, NamesTimeInMinutesAndHours) {
  EXPECT_EQ(formatWorkTime(0), "under a minute");
  EXPECT_EQ(formatWorkTime(minute - 1), "under a minute");
  EXPECT_EQ(formatWorkTime(minute), "1 min");
  EXPECT_EQ(formatWorkTime(59 * minute), "59 min");
  EXPECT_EQ(formatWorkTime(72 * minute), "1 h 12 min");
}

TEST(HandWorkText, NamesTheKindsOfCorrectionsThatOccurred) {
  EXPECT_EQ(describe(Corrections()), "none");
  EXPECT_EQ(describe({.edits = 1, .moved = 1}), "1 edit; nodes: 1 moved");
  EXPECT_EQ(describe({.edits = 4, .added = 2, .removed = 1, .retyped = 3}),
            "4 edits; nodes: 2 added, 1 removed, 3 with another edge type");
}

} // namespace
} // namespace espalier
