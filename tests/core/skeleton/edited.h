#pragma once

#include "core/base/error.h"
#include "core/skeleton/skeleton_delta.h"

#include <gtest/gtest.h>

#include <functional>
#include <gmock/gmock.h>
#include <string>

namespace espalier::test {

using Change = std::function<void(SkeletonEditor&)>;

/// The plant after a change.
inline Skeleton edited(Skeleton plant, const Change& change) {
  SkeletonEditor editor(plant);
  change(editor);
  (void)editor.commit();
  return plant;
}

/// The change is refused with a sentence that has `part`, before anything changed.
inline void expectRefused(Skeleton plant, const std::string& part, const Change& change) {
  SkeletonEditor editor(plant);
  EXPECT_THAT([&] { change(editor); }, testing::ThrowsMessage<Error>(testing::HasSubstr(part)));
  EXPECT_TRUE(editor.commit().isEmpty());
}

} // namespace espalier::test
