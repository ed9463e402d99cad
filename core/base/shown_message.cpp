#include "core/base/shown_message.h"

#include <utility>

namespace espalier {

std::string inEnglish(const ShownMessage& message) {
  std::string text;
  const std::string& sentence = message.sentence;
  for (std::size_t i = 0; i < sentence.size(); ++i) {
    const bool isPlace = sentence[i] == '%' && i + 1 < sentence.size() && sentence[i + 1] >= '1' &&
                         sentence[i + 1] <= '9';
    const auto number = isPlace ? static_cast<std::size_t>(sentence[i + 1] - '1') : 0;
    if (isPlace && number < message.values.size()) {
      text += message.values[number];
      ++i;
    } else {
      text += sentence[i];
    }
  }
  return text;
}

std::vector<std::string> eachInEnglish(const std::vector<ShownMessage>& messages) {
  std::vector<std::string> texts;
  for (const ShownMessage& message : messages)
    texts.push_back(inEnglish(message));
  return texts;
}

ShownError::ShownError(ShownMessage message)
    : Error(inEnglish(message)), message_(std::move(message)) {}

} // namespace espalier
