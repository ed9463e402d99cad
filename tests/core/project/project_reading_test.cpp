// A project that is read while another process or thread writes it.
#include "core/project/project.h"
#include "tests/core/project/edits_at_random.h"
#include "tests/support/plants.h"
#include "tests/support/shared_data.h"

#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <gmock/gmock.h>
#include <thread>

namespace espalier {
namespace {

TEST(Project, IsReadAsItWasAtOneMomentWhileAnotherWritesToIt) {
  const std::filesystem::path file = test::freshFolder() / "oak.espalier";
  test::EditsAtRandom edits({.skeleton = test::randomPlant(300, 5)}, 5);
  Project project = Project::create(file, edits.history());
  const Project reading = Project::open(file, Access::readOnly);
  std::atomic<bool> isWriting = true;
  const std::jthread writer([&] {
    for (int i = 0; i < 150; ++i) { // more would make each reading longer than the one before
      const auto act = edits.next();
      project.record(act.kept, act.added, act.position);
    }
    isWriting = false;
  });
  for (int i = 0; isWriting; ++i) {
    ASSERT_THAT(reading.lastWork().notes, testing::IsEmpty()) << "reading " << i;
    ASSERT_THAT(reading.history().notes, testing::IsEmpty()) << "reading " << i;
  }
}

} // namespace
} // namespace espalier
