#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace espalier::test {

/// A text as a botanist types it, and what it means.
struct HandTyped {
  const char* kind;   // of texts, as a name of a test
  std::string text;   // bytes of the file
  const char* counts; // vertices per scale from the scene on, edges <, edges +
  std::size_t notes = 0;
};

/// One text of each kind.
[[nodiscard]] const std::vector<HandTyped>& handTypedTexts();

/// A text that cannot be read with certainty, and what is said of it.
struct Doubtful {
  const char* kind;
  std::string text;
  const char* message;
};

[[nodiscard]] const std::vector<Doubtful>& doubtfulTexts();

inline void PrintTo(const HandTyped& typed, std::ostream* out) {
  *out << typed.kind;
}
inline void PrintTo(const Doubtful& typed, std::ostream* out) {
  *out << typed.kind;
}

} // namespace espalier::test
