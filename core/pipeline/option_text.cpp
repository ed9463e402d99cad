#include "core/pipeline/option_text.h"

#include <sstream>

namespace espalier {

std::string rangeText(const Option& option) {
  if (option.takesWords()) return option.words();
  std::ostringstream text;
  text << option.minimum << " to " << option.maximum;
  if (option.kind == OptionKind::length) text << " point spacings";
  if (option.kind == OptionKind::angle) text << " degrees";
  return text.str();
}

std::string summaryOf(const Option& option) {
  return nameOf(option.kind) + ", default " + option.ruleText() +
         (option.takesWords() ? ", one of " : ", range ") + rangeText(option);
}

} // namespace espalier
