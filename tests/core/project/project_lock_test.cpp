#include "core/project/project.h"
#include "tests/core/io/samples.h"
#include "tests/support/plants.h"
#include "tests/support/shared_data.h"

#include <csignal>
#include <fstream>
#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

namespace espalier {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

TEST(ProjectLock, ShowsASecondWindowWhoHoldsTheProject) {
  const fs::path file = test::freshFolder() / "oak.espalier";
  const Project first = Project::create(file, {.skeleton = test::fork(2)});
  EXPECT_THROW((void)Project::open(file, Access::readWrite), ProjectInUse);
  EXPECT_THAT(test::errorOf([&] { return Project::open(file, Access::readWrite).path(); }),
              HasSubstr("process " + std::to_string(::getpid()) + " on "));
  EXPECT_THROW((void)Project::create(file, {}), ProjectInUse) << "nor may it be replaced";
  EXPECT_TRUE(ProjectLock::holder(file));
}

TEST(ProjectLock, NamesTheFolderThatIsNotThere) {
  const fs::path folder = test::freshFolder() / "nowhere";
  const auto make = [&] { return Project::create(folder / "oak.espalier", {}).path(); };
  EXPECT_THAT(test::errorOf(make), HasSubstr("oak.espalier: there is no folder '"));
}

TEST(ProjectLock, LetsASecondWindowReadOnly) {
  const fs::path file = test::freshFolder() / "oak.espalier";
  const Project first = Project::create(file, {.skeleton = test::fork(2)});
  EXPECT_EQ(Project::open(file, Access::readOnly).history().value.skeleton, test::fork(2));
}

TEST(ProjectLock, EndsWithItsProject) {
  const fs::path file = test::freshFolder() / "oak.espalier";
  { const Project first = Project::create(file, {}); }
  EXPECT_FALSE(ProjectLock::holder(file));
  EXPECT_FALSE(fs::exists(file.string() + ".lock"));
  EXPECT_NO_THROW((void)Project::open(file, Access::readWrite));
}

TEST(ProjectLock, OfAKilledProgramIsTakenOver) {
  const fs::path file = test::freshFolder() / "oak.espalier";
  (void)Project::create(file, {.skeleton = test::fork(2)});
  int ready[2];
  ASSERT_EQ(::pipe(ready), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    const Project project = Project::open(file, Access::readWrite);
    (void)!::write(ready[1], "x", 1);
    ::pause();
    ::_exit(0);
  }
  char byte = 0;
  ASSERT_EQ(::read(ready[0], &byte, 1), 1);
  EXPECT_THROW((void)Project::open(file, Access::readWrite), ProjectInUse);
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  EXPECT_TRUE(fs::exists(file.string() + ".lock")) << "it could not tidy up";
  EXPECT_EQ(Project::open(file, Access::readWrite).history().value.skeleton, test::fork(2));
}

TEST(ProjectLock, KnowsAProjectUnderItsOtherNames) {
  const fs::path folder = test::freshFolder();
  const Project first = Project::create(folder / "oak.espalier", {});
  fs::create_symlink(folder / "oak.espalier", folder / "link.espalier");
  EXPECT_THROW((void)Project::open(folder / "link.espalier", Access::readWrite), ProjectInUse);
}

} // namespace
} // namespace espalier
