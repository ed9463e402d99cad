// Runs a fuzz target without a fuzzer: on every file of the folders and files it is given, and on
// seeded mutations of them. Prints what it did, and exits with 1 if the target was too slow.
//
//   fuzz_mtg ITERATIONS [FILE|FOLDER]...
//
// Before each run the input is written to a file beside the program, which a success removes: after
// a crash it holds the input that did it.
#include "tests/fuzz/mutation.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace espalier::test {
namespace {

constexpr std::size_t largestSeed = std::size_t{1} << 16; // larger files take longer, show no more
constexpr std::chrono::seconds longestRun{10}; // under sanitizers too; a healthy one takes ms

std::string bytesOf(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::string bytes(std::istreambuf_iterator<char>(in), {});
  bytes.resize(std::min(bytes.size(), largestSeed));
  return bytes;
}

/// The files at these paths and below them, in order of their names.
std::vector<std::string> corpusOf(const std::vector<std::filesystem::path>& places) {
  std::vector<std::filesystem::path> files;
  for (const std::filesystem::path& place : places) {
    if (std::filesystem::is_regular_file(place)) files.push_back(place);
    if (!std::filesystem::is_directory(place)) continue;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(place))
      if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::ranges::sort(files);
  std::vector<std::string> corpus;
  corpus.reserve(files.size() + 1);
  for (const std::filesystem::path& file : files)
    corpus.push_back(bytesOf(file));
  return corpus;
}

class Runner {
public:
  explicit Runner(std::filesystem::path suspect) : suspect_(std::move(suspect)) {}

  void run(const std::string& input) {
    std::ofstream(suspect_, std::ios::binary) << input;
    const auto start = std::chrono::steady_clock::now();
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
    slowest_ = std::max(slowest_, std::chrono::steady_clock::now() - start);
    ++runs_;
  }

  /// The exit status of the program.
  [[nodiscard]] int finish(std::size_t files) const {
    std::filesystem::remove(suspect_);
    const double seconds = std::chrono::duration<double>(slowest_).count();
    std::cout << runs_ << " inputs from " << files << " files, the slowest took " << seconds
              << " s\n";
    return slowest_ > longestRun ? EXIT_FAILURE : EXIT_SUCCESS;
  }

private:
  std::filesystem::path suspect_;
  std::chrono::steady_clock::duration slowest_{};
  std::size_t runs_ = 0;
};

int fuzz(const std::filesystem::path& program, std::size_t iterations,
         const std::vector<std::filesystem::path>& places) {
  std::vector<std::string> corpus = corpusOf(places);
  const std::size_t files = corpus.size();
  corpus.emplace_back(); // so that there is something to change
  Runner runner(program.string() + ".crash");
  for (const std::string& input : corpus)
    runner.run(input);
  Mutation mutation(corpus, 1);
  for (std::size_t i = 0; i < iterations; ++i)
    runner.run(mutation.next());
  return runner.finish(files);
}

} // namespace
} // namespace espalier::test

int main(int argc, char** argv) {
  if (argc < 2) {
    std::cerr << "usage: " << argv[0] << " ITERATIONS [FILE|FOLDER]...\n";
    return 2;
  }
  return espalier::test::fuzz(argv[0], std::strtoul(argv[1], nullptr, 10), {argv + 2, argv + argc});
}
