#include "core/io/plantgl/geom_text.h"

#include "core/base/text.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <utility>

namespace espalier {
namespace {

bool beginsName(char c) {
  return isLetter(c) || c == '_';
}

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

/// How many letters and digits `text` begins with.
std::size_t wordSize(std::string_view text) {
  const auto* end =
      std::ranges::find_if(text, [](char c) { return !beginsName(c) && !isDigit(c); });
  return static_cast<std::size_t>(end - text.begin());
}

const std::map<std::string_view, Color>& namedColors() {
  static const std::map<std::string_view, Color> colors = {
      {"Black", {0, 0, 0}},       {"Blue", {0, 0, 255}},    {"Cyan", {0, 255, 255}},
      {"Green", {0, 255, 0}},     {"Red", {255, 0, 0}},     {"Magenta", {255, 0, 255}},
      {"White", {255, 255, 255}}, {"Yellow", {255, 255, 0}}};
  return colors;
}

} // namespace

GeomText::GeomText(std::string_view text, std::string file) : text_(text), file_(std::move(file)) {
  for (GeomToken& token : ahead_)
    token = scan();
}

GeomToken GeomText::take() {
  const GeomToken taken = ahead_.front();
  std::rotate(ahead_.begin(), ahead_.begin() + 1, ahead_.end());
  ahead_.back() = scan();
  return taken;
}

bool GeomText::takeIf(char sign) {
  if (!next().is(sign)) return false;
  (void)take();
  return true;
}

void GeomText::require(char sign) {
  if (takeIf(sign)) return;
  if (isAtEnd()) failOfEnd();
  failAt(next().line,
         {espalier::Shown::tr("expected '%1', found %2: export the points as PLY or .bgeom"),
          {std::string(1, sign), inQuotes(next().text)}});
}

std::string_view GeomText::takeWord(const char* expected) {
  if (!next().isWord()) failOfNext(expected);
  return take().text;
}

double GeomText::takeNumber() {
  double sign = 1;
  while (next().is('-') || next().is('+'))
    if (take().is('-')) sign = -sign;
  if (next().kind == GeomToken::Kind::number) return sign * take().number;
  const auto special = next().isWord() ? numberIn(next().text) : std::nullopt;
  if (!special)
    failOfNext(
        espalier::Shown::tr("expected a number, found %1: export the points as PLY or .bgeom"));
  (void)take();
  return sign * *special;
}

Eigen::Vector3d GeomText::takeVector() {
  static const std::map<std::string_view, Eigen::Vector3d> axes = {
      {"OX", Eigen::Vector3d::UnitX()},
      {"OY", Eigen::Vector3d::UnitY()},
      {"OZ", Eigen::Vector3d::UnitZ()}};
  if (next().isWord())
    if (const auto axis = axes.find(next().text); axis != axes.end()) {
      (void)take();
      return axis->second;
    }
  Eigen::Vector3d result;
  require('<');
  result.x() = takeNumber();
  require(',');
  result.y() = takeNumber();
  require(',');
  result.z() = takeNumber();
  require('>');
  return result;
}

Color GeomText::takeColor() {
  const std::size_t line = next().line;
  const auto channel = [&] {
    const double value = takeNumber();
    if (!(value >= 0 && value <= 255))
      failAt(line, {espalier::Shown::tr("a part of a color is not between 0 and 255: correct it")});
    return static_cast<std::uint8_t>(value);
  };
  if (next().isWord()) {
    const auto named = namedColors().find(next().text);
    if (named == namedColors().end())
      failOfNext(
          espalier::Shown::tr("expected a color, found %1: export the points as PLY or .bgeom"));
    (void)take();
    return named->second;
  }
  Color result;
  if (!takeIf('<')) {
    result.fill(channel());
    return result;
  }
  for (std::size_t i = 0; i < result.size(); ++i) {
    if (i > 0) require(',');
    result[i] = channel();
  }
  if (takeIf(',')) (void)channel(); // how transparent
  require('>');
  return result;
}

void GeomText::skipLine() {
  const std::size_t line = next().line;
  while (!isAtEnd() && next().line == line)
    (void)take();
}

void GeomText::failOfNext(const char* expected) const {
  if (isAtEnd()) failOfEnd();
  failAt(next().line, {expected, {inQuotes(next().text)}});
}

void GeomText::failOfEnd() const {
  failAt(next().line,
         {espalier::Shown::tr("ends within an object: it is cut short, copy or export it again")});
}

void GeomText::failAt(std::size_t line, ShownMessage what) const {
  what.where = FilePlace{file_, line};
  throw ShownError(std::move(what));
}

GeomToken GeomText::scan() {
  skipBlanks();
  GeomToken token{.line = line_};
  if (offset_ == text_.size()) return token;
  if (isDigit(at()) || (at() == '.' && isDigit(at(1)))) return scanNumber();
  if (at() == '"') return scanQuoted();
  const bool isCommand = at() == ':' && beginsName(at(1));
  if (isCommand) ++offset_;
  const bool isWord = beginsName(at());
  const std::size_t size = isWord ? wordSize(text_.substr(offset_)) : 1;
  token.kind = GeomToken::Kind::sign;
  if (isWord) token.kind = isCommand ? GeomToken::Kind::command : GeomToken::Kind::word;
  token.text = text_.substr(offset_, size);
  offset_ += size;
  return token;
}

GeomToken GeomText::scanNumber() {
  GeomToken token{.kind = GeomToken::Kind::number, .line = line_};
  const char* begin = text_.data() + offset_;
  const char* end = std::from_chars(begin, text_.data() + text_.size(), token.number).ptr;
  token.text = text_.substr(offset_, static_cast<std::size_t>(end - begin));
  token.number = numberIn(token.text).value_or(0); // which rounds what is out of range
  offset_ += token.text.size();
  return token;
}

GeomToken GeomText::scanQuoted() {
  const std::size_t end = text_.find_first_of("\"\n", offset_ + 1);
  if (end == std::string_view::npos || text_[end] == '\n')
    failAt(line_,
           {espalier::Shown::tr("a quoted text does not end in its line: the file is damaged")});
  const GeomToken token{.kind = GeomToken::Kind::quoted,
                        .text = text_.substr(offset_ + 1, end - offset_ - 1),
                        .line = line_};
  offset_ = end + 1;
  return token;
}

void GeomText::skipBlanks() {
  for (; offset_ < text_.size(); ++offset_) {
    if (at() == '\n') ++line_;
    if (at() == '#') {
      offset_ = std::min(text_.find('\n', offset_), text_.size()) - 1;
    } else if (at() == '(' && at(1) == '#') {
      skipComment();
    } else if (at() != ' ' && at() != '\t' && at() != '\r' && at() != '\n') {
      return;
    }
  }
}

/// Leaves the last sign of the comment to be passed over.
void GeomText::skipComment() {
  const std::size_t end = text_.find("#)", offset_ + 2);
  if (end == std::string_view::npos)
    failAt(line_, {espalier::Shown::tr(
                      "a comment that begins with (# has no end #): the file is cut short")});
  line_ += static_cast<std::size_t>(std::ranges::count(text_.substr(offset_, end - offset_), '\n'));
  offset_ = end + 1;
}

} // namespace espalier
