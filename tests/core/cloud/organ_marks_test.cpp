#include "core/cloud/organ_marks.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

TEST(OrganMarks, GiveAPointOneOrganAtMost) {
  const OrganMarks blades = OrganMarks().with(PointSet::of({1, 2, 3}), Organ::blade);
  const OrganMarks mixed = blades.with(PointSet::of({3, 4}), Organ::wood);
  EXPECT_EQ(mixed.of(Organ::blade), PointSet::of({1, 2}));
  EXPECT_EQ(mixed.of(Organ::wood), PointSet::of({3, 4}));
  EXPECT_EQ(mixed.all(), PointSet::of({1, 2, 3, 4}));
  EXPECT_EQ(mixed.with(PointSet::of({1, 2, 3, 4}), std::nullopt), OrganMarks());
}

TEST(OrganMarks, ChangeFromOneStateToAnotherAndBack) {
  const OrganMarks before = OrganMarks().with(PointSet::of({1, 2, 3}), Organ::blade);
  const OrganMarks after = before.with(PointSet::of({2, 7}), Organ::needle);
  const OrganMarks change = before ^ after;
  EXPECT_EQ(change.of(Organ::blade), PointSet::of({2})) << "what it was";
  EXPECT_EQ(change.of(Organ::needle), PointSet::of({2, 7})) << "and what it is";
  EXPECT_EQ(before ^ change, after);
  EXPECT_EQ(after ^ change, before);
  EXPECT_TRUE((change ^ change).isEmpty());
}

} // namespace
} // namespace espalier
