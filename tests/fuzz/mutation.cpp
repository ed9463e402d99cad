#include "tests/fuzz/mutation.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace espalier::test {
namespace {

constexpr std::size_t mostChanges = 8;

/// What parsers stumble over.
constexpr auto traps = std::to_array<std::string_view>({"0",
                                                        "-1",
                                                        "4294967295",
                                                        "2147483648",
                                                        "99999999999999999999",
                                                        "1e999",
                                                        "nan",
                                                        "\n",
                                                        "\r\n",
                                                        "\t",
                                                        ",",
                                                        "\"",
                                                        "<",
                                                        ">",
                                                        "/",
                                                        "&",
                                                        std::string_view("\0\0\0\0", 4),
                                                        "\xff\xff\xff\xff",
                                                        "\xff\xff\xff\x7f",
                                                        "\xEF\xBB\xBF",
                                                        "\xC3"});

} // namespace

Mutation::Mutation(const std::vector<std::string>& corpus, std::uint64_t seed)
    : corpus_(corpus), random_(seed) {}

std::string Mutation::next() {
  std::string input = corpus_[below(corpus_.size())];
  for (std::size_t changes = 1 + below(mostChanges); changes > 0; --changes)
    spoil(input);
  return input;
}

std::size_t Mutation::below(std::size_t end) {
  return static_cast<std::size_t>(random_() % end); // the same on every machine, unlike std's
}

void Mutation::spoil(std::string& input) {
  if (input.empty()) return splice(input);
  const std::size_t at = below(input.size());
  switch (below(7)) {
  case 0:
    input[at] = static_cast<char>(input[at] ^ static_cast<char>(1U << below(8)));
    break;
  case 1:
    input[at] = static_cast<char>(below(256));
    break;
  case 2:
    input.erase(at, 1 + below(16));
    break;
  case 3:
    input.insert(at, input.substr(at, 1 + below(64)));
    break;
  case 4:
    input.resize(at);
    break;
  case 5:
    input.insert(at, traps[below(traps.size())]);
    break;
  default:
    splice(input);
  }
}

void Mutation::splice(std::string& input) {
  const std::string& other = corpus_[below(corpus_.size())];
  if (other.empty()) {
    input += traps[below(traps.size())];
    return;
  }
  const std::size_t from = below(other.size());
  input.insert(below(input.size() + 1), other.substr(from, 1 + below(256)));
}

} // namespace espalier::test
