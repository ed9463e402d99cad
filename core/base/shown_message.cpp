#include "core/base/shown_message.h"

#include <utility>

namespace espalier {

std::string inEnglish(const FilePlace& place) {
  std::string text = place.file;
  if (place.line) text += ", line " + std::to_string(*place.line);
  if (place.column) text += ", column " + std::to_string(*place.column);
  if (place.byte) text += ", byte " + std::to_string(*place.byte);
  return text;
}

std::string inEnglish(const ShownMessage& message) {
  std::string text;
  if (message.where) text = inEnglish(*message.where) + ": ";
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
  texts.reserve(messages.size());
  for (const ShownMessage& message : messages)
    texts.push_back(inEnglish(message));
  return texts;
}

ShownMessage messageOf(const std::exception& error) {
  const auto* shown = dynamic_cast<const ShownError*>(&error);
  return shown != nullptr ? shown->message() : ShownMessage{"%1", {error.what()}};
}

ShownError::ShownError(ShownMessage message)
    : Error(inEnglish(message)), message_(std::move(message)) {}

} // namespace espalier
