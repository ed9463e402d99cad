#include "core/skeleton/label_index.h"

#include <algorithm>
#include <charconv>
#include <limits>

namespace espalier {
namespace {

/// The numbers between dots; none if something else stands there.
std::optional<std::vector<int>> numbersIn(std::string_view text) {
  std::vector<int> numbers;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find('.', at), text.size());
    const char* last = text.data() + end;
    int number = 0;
    const auto [stop, error] = std::from_chars(text.data() + at, last, number);
    if (stop != last || error != std::errc{}) return std::nullopt;
    numbers.push_back(number);
    at = end + 1;
  }
  return numbers;
}

bool isLower(const std::optional<LabelIndex>& a, const LabelIndex& b) {
  return !a || a->parts() < b.parts();
}

} // namespace

std::optional<LabelIndex> LabelIndex::in(std::string_view text) {
  if (text.find('-') != std::string_view::npos || !numbersIn(text)) return std::nullopt;
  LabelIndex index;
  index.text_ = text;
  return index;
}

std::vector<int> LabelIndex::parts() const {
  return *numbersIn(text_);
}

std::optional<LabelIndex> LabelIndex::next() const {
  const std::size_t dot = text_.rfind('.');
  const std::size_t start = dot == std::string::npos ? 0 : dot + 1;
  const int last = parts().back();
  if (last == std::numeric_limits<int>::max()) return std::nullopt;
  std::string number = std::to_string(last + 1);
  const bool isPadded = text_[start] == '0' && text_.size() - start > number.size();
  if (isPadded) number.insert(0, text_.size() - start - number.size(), '0');
  LabelIndex result;
  result.text_ = text_.substr(0, start) + number;
  return result;
}

void IndicesInUse::take(const LabelIndex& index) {
  if (isLower(highest_, index)) highest_ = index;
  if (!index.isDotted())
    areAllDotted_ = false;
  else if (isLower(highestDotted_, index))
    highestDotted_ = index;
}

std::optional<LabelIndex> IndicesInUse::next() const {
  if (!highest_) return LabelIndex(1);
  if (!highest_->isDotted()) return highest_->next();
  const std::string& text = highest_->text();
  const auto place = LabelIndex::in(std::string_view(text).substr(0, text.find('.')))->next();
  return place && areAllDotted_ ? LabelIndex::in(place->text() + ".1") : place;
}

std::optional<LabelIndex> IndicesInUse::nextAtPlace() const {
  return highestDotted_ ? highestDotted_->next() : std::nullopt;
}

} // namespace espalier
