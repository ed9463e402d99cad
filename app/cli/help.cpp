#include "app/cli/help.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

namespace espalier {
namespace {

constexpr std::size_t pageWidth = 80;
constexpr char unbroken = '\x1f'; // a blank where no line may end; istream takes it for no blank

struct Row {
  std::string term;
  std::string text;
};

/// Rows under a title, their texts wrapped and starting in one column.
std::string tableOf(const std::string& title, const std::vector<Row>& rows) {
  if (rows.empty()) return {};
  std::size_t column = 0;
  for (const Row& row : rows)
    column = std::max(column, row.term.size() + 4);
  std::string page = "\n" + title + ":\n";
  for (const Row& row : rows) {
    std::string line = "  " + row.term + std::string(column - row.term.size() - 2, ' ');
    std::istringstream words(row.text);
    for (std::string word; words >> word;) {
      if (line.size() > column && line.size() + 1 + word.size() > pageWidth) {
        page += line + '\n';
        line.assign(column, ' ');
      }
      line += (line.size() > column ? " " : "") + word;
    }
    page += line + '\n';
  }
  std::replace(page.begin(), page.end(), unbroken, ' ');
  return page;
}

bool isFlag(const CLI::Option& option) {
  return option.get_type_size() == 0;
}

std::string termOf(const CLI::Option& option) {
  if (option.get_positional()) return option.get_name(true);
  std::string names = option.get_name(false, true); // "-o,--output"
  if (const std::size_t comma = names.find(','); comma != std::string::npos)
    names.insert(comma + 1, " ");
  else
    names.insert(0, "    "); // under the long names of those that have a short one
  return isFlag(option) ? names : names + ' ' + option.get_type_name();
}

std::string helpTextOf(const CLI::Option& option) {
  const std::string byDefault = option.get_default_str();
  if (byDefault.empty()) return option.get_description();
  std::string note = "(default: " + byDefault + ")";
  std::replace(note.begin(), note.end(), ' ', unbroken);
  return option.get_description() + ' ' + note;
}

std::string shortNameOf(const CLI::Option& option) {
  return option.get_snames().empty() ? option.get_name() : '-' + option.get_snames().front();
}

std::string usageOf(const CLI::App& command, const std::string& name) {
  std::string usage = "Usage: " + name;
  const auto add = [&](const std::string& argument, const CLI::Option& option) {
    const std::string all =
        argument +
        (option.get_expected_max() == CLI::detail::expected_max_vector_size ? "..." : "");
    usage += ' ' + (option.get_required() ? all : '[' + all + ']');
  };
  for (const CLI::Option* option : command.get_options())
    if (option->get_positional()) add(option->get_name(true), *option);
  for (const CLI::Option* option : command.get_options())
    if (!option->get_positional() && option->get_required())
      add(shortNameOf(*option) + ' ' + option->get_type_name(), *option);
  return usage + " [OPTION]...\n";
}

std::string argumentsOf(const CLI::App& command) {
  std::vector<Row> positionals;
  std::vector<Row> options;
  for (const CLI::Option* option : command.get_options())
    (option->get_positional() ? positionals : options)
        .push_back({termOf(*option), helpTextOf(*option)});
  return tableOf("Arguments", positionals) + tableOf("Options", options);
}

class HelpFormatter : public CLI::FormatterBase {
public:
  [[nodiscard]] std::string make_help(const CLI::App* command, std::string name,
                                      CLI::AppFormatMode /*mode*/) const override {
    std::vector<Row> subcommands;
    for (const CLI::App* subcommand : command->get_subcommands({}))
      subcommands.push_back({subcommand->get_name(), subcommand->get_description()});
    const std::string usage = subcommands.empty()
                                  ? usageOf(*command, name)
                                  : "Usage: espalier [FILE]...                 opens the editor\n"
                                    "       espalier SUBCOMMAND [ARGUMENT]...  needs no display\n";
    const std::string footer = command->get_footer();
    return command->get_description() + ".\n\n" + usage + tableOf("Subcommands", subcommands) +
           argumentsOf(*command) + (footer.empty() ? "" : '\n' + footer + '\n');
  }
};

} // namespace

std::shared_ptr<CLI::FormatterBase> makeHelpFormatter() {
  return std::make_shared<HelpFormatter>();
}

} // namespace espalier
