// What the headers of core offer is called by the program: what tests alone call is no part of it.
#include "tests/support/shared_data.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace espalier {
namespace {

using Names = std::set<std::string>;

/// Header and function -> why no file but those of its own pair names it.
const std::map<std::pair<std::string, std::string>, std::string> exceptions = {
    {{"core/surface/envelopes/asymmetric_hull.h", "meshOf"}, "of the hull that a fit finds"},
    {{"core/clean/plants.h", "plantsAmong"}, "a step of another, tested by itself"},
    {{"core/clean/plants.h", "resolved"}, "a function beside it calls it"},
    {{"core/clean/pole.h", "resolved"}, "a function beside it calls it"},
    {{"core/clean/wire.h", "resolved"}, "a function beside it calls it"},
    {{"core/skeleton/checks_of_scan.h", "edgesWithoutPoints"},
     "checkAgainstScan() beside it calls it"},
    {{"core/skeleton/checks_of_scan.h", "unexplainedClusters"},
     "checkAgainstScan() beside it calls it"},
    {{"core/clean/organ_odds.h", "featuresAround"},
     "a function beside it and the fit of the odds call it"},
    {{"core/clean/organ_odds.h", "sharesAlone"},
     "a function beside it and the fit of the odds call it"},
    {{"core/decide/attachment_odds.h", "featuresOf"},
     "a function beside it and the fit of the odds call it"},
    {{"core/decide/attachment_odds.h", "fittedAttachmentOdds"},
     "odds that a function beside it has unless it is given others"},
    {{"core/base/quadratic.h", "scaled"}, "a function beside it and fits of odds call it"},
    {{"core/decide/end_odds.h", "featuresAmongAll"},
     "a function beside it and the fit of the odds call it"},
    {{"core/doubt/missing_branches.h", "featuresOf"},
     "a function beside it and the fit of the odds call it"},
    {{"core/doubt/finding_gain.h", "woodOf"},
     "a function beside it and the measure of the chances call it"},
    {{"core/radius/radius_evidence.h", "featuresOf"},
     "a function beside it and the fit of the errors call it"},
    {{"core/evaluate/traits/strahler.h", "strahlerNumbers"}, "a step of another, tested by itself"},
    {{"core/graph/geodesic_balls.h", "ballGroups"}, "the templates beside it call it"},
    {{"core/graph/geodesic_balls.h", "of"}, "the templates beside it call it"},
    {{"core/mtg/mtg_cells.h", "textOf"}, "a function beside the class calls it"},
    {{"core/project/piece_writer.h", "fraction"}, "a function beside the class calls it"},
    {{"core/project/node_bytes.h", "storedIdEnd"}, "a step of another, tested by itself"},
    {{"core/simulate/foliage.h", "hit"}, "PieceTree calls it for its argument"},
    {{"core/skeleton/label_index.h", "isDotted"}, "a function beside the class calls it"}};

/// Without comments, text in quotes and preprocessor lines.
std::string codeOf(const std::string& text) {
  static const std::regex other(
      R"(//[^\n]*|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])'|(?:^|\n)\s*#[^\n]*)");
  return std::regex_replace(text, other, " ");
}

struct Source {
  std::string code;
  Names words;
  std::vector<std::string> includes;
};

Source read(const std::filesystem::path& path) {
  std::ostringstream stream;
  stream << std::ifstream(path).rdbuf();
  const std::string text = stream.str();
  Source source{.code = codeOf(text), .words = {}, .includes = {}};
  static const std::regex word(R"([A-Za-z_]\w*)");
  static const std::regex include(R"re(#include "([^"]+)")re");
  for (std::sregex_iterator at(source.code.begin(), source.code.end(), word), end; at != end; ++at)
    source.words.insert(at->str());
  for (std::sregex_iterator at(text.begin(), text.end(), include), end; at != end; ++at)
    source.includes.push_back((*at)[1]);
  return source;
}

const std::map<std::string, Source>& sources() {
  static const auto all = [] {
    std::map<std::string, Source> found;
    for (const char* top : {"core", "ui", "app"})
      for (const auto& entry :
           std::filesystem::recursive_directory_iterator(test::sourceFolder() / top))
        if (entry.path().extension() == ".h" || entry.path().extension() == ".cpp")
          found.emplace(entry.path().lexically_relative(test::sourceFolder()).string(),
                        read(entry.path()));
    return found;
  }();
  return all;
}

/// Files that include a header, directly or not -> by header.
const std::map<std::string, Names>& users() {
  static const auto all = [] {
    std::map<std::string, Names> found;
    for (const auto& [file, source] : sources()) {
      std::vector<std::string> open = source.includes;
      while (!open.empty()) {
        const std::string header = open.back();
        open.pop_back();
        if (!sources().contains(header) || !found[header].insert(file).second) continue;
        const auto& more = sources().at(header).includes;
        open.insert(open.end(), more.begin(), more.end());
      }
    }
    return found;
  }();
  return all;
}

/// The name of the function that is declared, if it is one; no constructor, no operator.
std::string functionIn(std::string declaration) {
  static const std::regex attribute(R"(\[\[[^\]]*\]\])");
  static const std::regex parameters(R"(template\s*<[^{;]*?>\s(?=\s*[A-Za-z\[]))");
  static const std::regex function(R"(^[^=(]*?\b([a-z_]\w*)\s*\()");
  static const std::regex other(R"(^\s*(using|typedef|friend|static_assert)\b)");
  declaration = std::regex_replace(declaration, attribute, " ");
  declaration = std::regex_replace(declaration, parameters, " ");
  std::smatch match;
  if (std::regex_search(declaration, other)) return {};
  if (!std::regex_search(declaration, match, function)) return {};
  const std::string name = match[1];
  return declaration.substr(0, static_cast<std::size_t>(match.position(1))).find("operator") !=
                     std::string::npos ||
                 name == "operator"
             ? std::string()
             : name;
}

/// Follows the braces of a header.
class HeaderReader {
public:
  Names publicFunctions(const std::string& code) {
    for (const char c : code) {
      parentheses_ += (c == '(') - (c == ')');
      if (parentheses_ > 0 || (c != '{' && c != '}' && c != ';'))
        take(c);
      else if (c == '}')
        close();
      else
        end(c == '{');
    }
    return names_;
  }

private:
  enum class Scope { open, hidden, body };

  void take(char c) {
    static const std::regex access(R"(\b(public|private|protected)\s*:$)");
    statement_ += c;
    std::smatch match;
    if (c != ':' || !std::regex_search(statement_, match, access) || scopes_.empty()) return;
    scopes_.back() = match[1] == "public" ? Scope::open : Scope::hidden;
    statement_.clear();
  }

  void close() {
    if (!scopes_.empty()) scopes_.pop_back();
    statement_.clear();
  }

  void end(bool isBlock) {
    static const std::regex space(R"(\bnamespace\b[^()]*$)");
    static const std::regex enumeration(R"(\benum\b[^()]*$)");
    static const std::regex structure(R"(\bstruct\b[^()=]*$)");
    static const std::regex klass(R"(\bclass\b[^()=]*$)");
    const auto is = [&](const std::regex& kind) { return std::regex_search(statement_, kind); };
    const bool isSeen =
        std::ranges::all_of(scopes_, [](Scope scope) { return scope == Scope::open; });
    if (!isBlock || !(is(space) || is(enumeration) || is(structure) || is(klass)))
      if (std::string name = functionIn(statement_); isSeen && !name.empty())
        names_.insert(std::move(name));
    if (isBlock)
      scopes_.push_back(is(enumeration)              ? Scope::body
                        : is(space) || is(structure) ? Scope::open
                        : is(klass)                  ? Scope::hidden
                                                     : Scope::body);
    statement_.clear();
  }

  Names names_;
  std::string statement_;
  std::vector<Scope> scopes_;
  int parentheses_ = 0;
};

bool isReached(const std::string& header, const std::string& function) {
  const auto found = users().find(header);
  if (found == users().end()) return false;
  const std::string own = header.substr(0, header.size() - 1) + "cpp";
  return std::ranges::any_of(found->second, [&](const std::string& file) {
    return file != header && file != own && sources().at(file).words.contains(function);
  });
}

// A word is taken for a call wherever the header is known: the rest would need a compiler.
TEST(PublicFunctions, OfCoreAreCalledByTheProgram) {
  std::size_t seen = 0;
  for (const auto& [file, source] : sources()) {
    if (!file.starts_with("core/") || !file.ends_with(".h")) continue;
    for (const std::string& function : HeaderReader().publicFunctions(source.code)) {
      ++seen;
      EXPECT_NE(isReached(file, function), exceptions.contains({file, function}))
          << file << ": " << function;
    }
  }
  EXPECT_GT(seen, 800U); // it reads what it judges
}

TEST(PublicFunctions, AreFoundInAHeader) {
  const std::string header = R"re(
    #define none(x)
    namespace a { [[nodiscard]] double free(int x); // not(this)
    template <class T, class U = int> T made(T x) { return inside(x); }
    struct S { int value = init(); bool is() const { return false; } S(int); bool operator==(int);
      static S of(const char* text = "not(this)"); };
    class C { void hidden(); public: int shown() const; private: int alsoHidden(); };
    enum class E { first = sizeof(int) };
    using F = int (*)(int); })re";
  EXPECT_EQ(HeaderReader().publicFunctions(codeOf(header)),
            (Names{"free", "is", "made", "of", "shown"}));
}

} // namespace
} // namespace espalier
