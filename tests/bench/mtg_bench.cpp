// Times MTG text: read, written, edited in place. A plant of 20 000 lines at three scales.
#include "core/mtg/mtg_reader.h"
#include "core/mtg/mtg_text_edit.h"
#include "core/mtg/mtg_writer.h"

#include <benchmark/benchmark.h>

#include <sstream>

namespace espalier {
namespace {

/// Axes of 20 nodes, each with values in four columns, on one trunk.
std::string plantText(int lines) {
  std::string text = "CODE :\tFORM-A\nCLASSES :\nP\t1\nA\t2\nN\t3\nFEATURES :\nXX\tREAL\nYY\tREAL\n"
                     "ZZ\tREAL\nradius\tREAL\nMTG :\nENTITY-CODE\t\t\tXX\tYY\tZZ\tradius\n"
                     "/P1/A1/N1\t\t\t0\t0\t0\t1\n";
  for (int i = 2; i <= lines; ++i) {
    const std::string number = std::to_string(i);
    const std::string values = "-218.88" + number + "\t1271.07" + number + "\t612.98\t0.5";
    const int place = (i - 2) % 21;
    text += place == 0   ? "^<N" + number + "\t\t\t"
            : place == 1 ? "\t+A" + number + "/N" + number + "\t\t"
                         : "\t^<N" + number + "\t\t";
    text += values + '\n';
  }
  return text;
}

const std::string& plant() {
  static const std::string text = plantText(20'000);
  return text;
}

Mtg read(const std::string& text) {
  std::istringstream in(text);
  return readMtg(in, "plant.mtg").value;
}

void readMtgText(benchmark::State& state) {
  for (auto _ : state)
    benchmark::DoNotOptimize(read(plant()));
}
void writeMtgText(benchmark::State& state) {
  const Mtg mtg = read(plant());
  for (auto _ : state) {
    std::ostringstream out;
    writeMtg(out, mtg);
    benchmark::DoNotOptimize(out.str());
  }
}
void moveOneNode(benchmark::State& state) {
  Mtg mtg = read(plant());
  mtg.vertices.back().values[0] = "8";
  for (auto _ : state)
    benchmark::DoNotOptimize(mtgTextWith(plant(), mtg));
}

BENCHMARK(readMtgText)->Unit(benchmark::kMillisecond);
BENCHMARK(writeMtgText)->Unit(benchmark::kMillisecond);
BENCHMARK(moveOneNode)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace espalier
