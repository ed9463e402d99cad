#pragma once

#include "core/base/shown_message.h"
#include "core/cloud/point_cloud.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace espalier {

/// A word of a text scene of PlantGL, as its grammar has them.
struct GeomToken {
  enum class Kind : std::uint8_t { end, word, number, quoted, command, sign };

  Kind kind = Kind::end;
  std::string_view text; // of a command without its colon, of a quoted text without its quotes
  double number = 0;
  std::size_t line = 0; // from 1

  [[nodiscard]] bool isWord() const { return kind == Kind::word; }
  [[nodiscard]] bool is(char sign) const { return kind == Kind::sign && text[0] == sign; }
};

/// Takes the tokens off a text scene of PlantGL one after another. Blanks part them, and comments:
/// "# to the end of the line" and "(# any lines #)".
///
/// Errors name the file and the line. For all that take: @throws Error also if what comes next is
/// no token, as in a comment without an end.
class GeomText {
public:
  static constexpr std::size_t farthest = 3; // tokens that can be seen before they are taken

  /// @param text  must outlive the reader
  /// @param file  its name, for messages
  GeomText(std::string_view text, std::string file);

  [[nodiscard]] const GeomToken& next(std::size_t ahead = 0) const { return ahead_[ahead]; }
  [[nodiscard]] bool isAtEnd() const { return next().kind == GeomToken::Kind::end; }
  [[nodiscard]] std::size_t offset() const { return offset_; } // bytes read so far

  GeomToken take();
  bool takeIf(char sign); // whether it came
  /// @throws Error if another comes
  void require(char sign);
  /// @throws Error if no word comes, by failOfNext(expected)
  std::string_view takeWord(const char* expected);
  /// A number, its sign before it; "nan" and "inf" are some.
  /// @throws Error if none comes
  double takeNumber();
  /// "<x, y, z>" or "OX", "OY", "OZ".
  /// @throws Error if none comes
  Eigen::Vector3d takeVector();
  /// "<r, g, b>", "<r, g, b, a>", a gray, or "Red" and the like.
  /// @throws Error if none comes, or a part is not between 0 and 255
  Color takeColor();
  /// Passes over the rest of the line of the token that comes next, and that.
  void skipLine();

  /// @param expected  a sentence on it, with %1 for what comes next
  /// @throws ShownError always: "oak.geom, line 12: expected a word, found 'Sphere'", or failOfEnd
  [[noreturn]] void failOfNext(const char* expected) const;
  /// @throws ShownError always: the file ends too early
  [[noreturn]] void failOfEnd() const;
  /// @throws ShownError always: "oak.geom, line 12: what"
  [[noreturn]] void failAt(std::size_t line, ShownMessage what) const;

private:
  GeomToken scan();
  GeomToken scanNumber();
  GeomToken scanQuoted();
  void skipBlanks();
  void skipComment();
  [[nodiscard]] char at(std::size_t ahead = 0) const {
    return offset_ + ahead < text_.size() ? text_[offset_ + ahead] : '\0';
  }

  std::string_view text_;
  std::string file_;
  std::size_t offset_ = 0;
  std::size_t line_ = 1;
  std::array<GeomToken, farthest> ahead_;
};

} // namespace espalier
