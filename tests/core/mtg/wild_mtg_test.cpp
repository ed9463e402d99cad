// MTGs as no plant is, but a file may be: long, wide and deep. Each is read, made a skeleton and
// written, within the time and memory of other files of its size.
#include "core/mtg/mtg_skeleton.h"
#include "core/mtg/mtg_writer.h"
#include "core/project/project.h"
#include "core/skeleton/checks.h"
#include "tests/core/mtg/mtg_text.h"
#include "tests/support/shared_data.h"

#include <gtest/gtest.h>

#include <string>

namespace espalier {
namespace {

constexpr int many = 100'000;

/// One axis or many branches of 100 000 vertices, whose topological columns are three.
std::string rowsOf(const std::string& before) {
  std::string rows = "/P1/A1/E1\t\t\t0\t0\t0\t\n";
  for (int i = 2; i <= many; ++i)
    rows += before + "E" + std::to_string(i) + (before == "^<" ? "\t\t\t" : "\t\t") +
            std::to_string(i % 317) + '\t' + std::to_string(i % 331) + '\t' + std::to_string(i) +
            "\t\n";
  return rows;
}

void expectReadAndWritten(const std::string& rows, std::size_t nodes) {
  const Mtg mtg = test::readMtgRows(rows).value;
  const Skeleton plant = skeletonOf(mtg, "plant.mtg").value;
  EXPECT_EQ(plant.size(), nodes);
  const std::string text = test::written(mtg);
  EXPECT_LT(text.size(), 3 * rows.size() + 4096) << "no file of another size";
  std::istringstream in(text);
  EXPECT_EQ(readMtg(in, "again.mtg").value, mtg);
}

TEST(WildMtg, WithAnAxisOfAHundredThousandVerticesIsRead) {
  expectReadAndWritten(rowsOf("^<"), many);
}

TEST(WildMtg, WithAHundredThousandBranchesOfOneVertexIsRead) {
  expectReadAndWritten(rowsOf("\t+"), many);
}

// Each branch is borne by the one before: as written, a column more each.
TEST(WildMtg, WithBranchesOfOrderAThousandIsRead) {
  constexpr int orders = 1000;
  const std::string columns(orders, '\t');
  std::string text = test::mtgText("");
  text.replace(text.find("ENTITY-CODE\t\t\t"), 14, "ENTITY-CODE" + columns);
  text += "/P1/A1/E1" + columns + "0\t0\t0\t\n";
  for (int i = 1; i < orders; ++i)
    text += std::string(i, '\t') + "+E" + std::to_string(i + 1) + std::string(orders - i, '\t') +
            "0\t0\t" + std::to_string(i) + "\t\n";
  std::istringstream in(text);
  const Mtg mtg = readMtg(in, "plant.mtg").value;
  const Skeleton plant = skeletonOf(mtg, "plant.mtg").value;
  ASSERT_EQ(plant.size(), std::size_t{orders});
  EXPECT_EQ(check(plant).size() > 0, true) << "no plant is like that, and it is said";
  std::istringstream again(test::written(mtg));
  EXPECT_EQ(readMtg(again, "again.mtg").value, mtg);
}

// Names are values of statements, never a part of them.
TEST(WildMtg, WithSqlInItsNamesIsKeptByAProject) {
  const std::string name = "x'); DROP TABLE journal; --";
  std::string text = test::mtgText("/P1/A1/E1\t\t\t0\t0\t0\t1\n");
  text.replace(text.find("\tradius\n"), 8, '\t' + name + '\n');
  std::istringstream in(text);
  const Mtg mtg = readMtg(in, "plant.mtg").value;
  const History history{.skeleton = skeletonOf(mtg, "plant.mtg").value};
  const auto file = test::freshFolder() / "a'); DROP TABLE journal; --.espalier";
  {
    Project project = Project::create(file, history);
    project.setDocument("mtg", text);
    project.setDocument(name, name);
  }
  const Project project = Project::open(file, Access::readOnly);
  EXPECT_EQ(project.history().value, history);
  EXPECT_EQ(project.document("mtg"), text);
  EXPECT_EQ(project.document(name), name);
}

} // namespace
} // namespace espalier
