#include "tests/app/cli/program.h"

#include "tests/support/shared_data.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <fcntl.h>
#include <fstream>
#include <gmock/gmock.h>
#include <iterator>
#include <spawn.h>
#include <stdexcept>
#include <string_view>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

namespace espalier::test {
namespace {

void require(bool holds, const char* what) {
  if (!holds) throw std::runtime_error(what);
}

/// The environment of a job on a cluster: no display, no session of a user.
std::vector<std::string> plainEnvironment() {
  constexpr auto without = std::to_array<std::string_view>(
      {"DISPLAY=", "WAYLAND_DISPLAY=", "XDG_RUNTIME_DIR=", "QT_QPA_PLATFORM="});
  std::vector<std::string> result;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string_view text = *entry;
    if (std::none_of(without.begin(), without.end(),
                     [&](std::string_view name) { return text.starts_with(name); }))
      result.emplace_back(text);
  }
  return result;
}

std::vector<char*> pointersTo(std::vector<std::string>& texts) {
  std::vector<char*> result;
  result.reserve(texts.size() + 1);
  for (std::string& text : texts)
    result.push_back(text.data());
  result.push_back(nullptr);
  return result;
}

/// What a started program does first: opens the files it talks to.
class Redirections {
public:
  Redirections() {
    posix_spawn_file_actions_init(&actions_);
    open(STDIN_FILENO, "/dev/null", O_RDONLY);
  }
  ~Redirections() { posix_spawn_file_actions_destroy(&actions_); }
  Redirections(const Redirections&) = delete;
  Redirections& operator=(const Redirections&) = delete;

  void open(int descriptor, const std::string& file, int flags) {
    posix_spawn_file_actions_addopen(&actions_, descriptor, file.c_str(), flags, 0);
  }
  void copy(int from, int to) { posix_spawn_file_actions_adddup2(&actions_, from, to); }
  [[nodiscard]] const posix_spawn_file_actions_t* get() const { return &actions_; }

private:
  posix_spawn_file_actions_t actions_{};
};

/// Starts the program; signals do there what they do by default, whoever runs these tests.
/// @param more  variables beside those of plainEnvironment, as "NAME=value"
pid_t start(const Arguments& arguments, const Redirections& redirections,
            const std::vector<std::string>& more = {}) {
  std::vector<std::string> words = {ESPALIER_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<std::string> environment = plainEnvironment();
  environment.insert(environment.end(), more.begin(), more.end());
  posix_spawnattr_t attributes{};
  posix_spawnattr_init(&attributes);
  sigset_t signals{};
  sigemptyset(&signals);
  for (const int signal : {SIGINT, SIGTERM, SIGPIPE})
    sigaddset(&signals, signal);
  posix_spawnattr_setsigdefault(&attributes, &signals);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
  pid_t child = 0;
  const int problem = posix_spawn(&child, ESPALIER_PROGRAM, redirections.get(), &attributes,
                                  pointersTo(words).data(), pointersTo(environment).data());
  posix_spawnattr_destroy(&attributes);
  require(problem == 0, "the program cannot be started");
  return child;
}

int waitFor(pid_t child) {
  int status = 0;
  require(::waitpid(child, &status, 0) == child, "the program is lost");
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/// A file without a name that takes what a program says.
class Recorder {
public:
  Recorder() : descriptor_(::memfd_create("output", MFD_CLOEXEC)) {
    require(descriptor_ >= 0, "there is no memory for output");
  }
  ~Recorder() { ::close(descriptor_); }
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  [[nodiscard]] int descriptor() const { return descriptor_; }

  [[nodiscard]] std::string text() const {
    std::string result;
    std::array<char, 4096> block{};
    for (ssize_t got = 0; (got = ::pread(descriptor_, block.data(), block.size(),
                                         static_cast<off_t>(result.size()))) > 0;)
      result.append(block.data(), static_cast<std::size_t>(got));
    return result;
  }

private:
  int descriptor_;
};

Outcome run(const Arguments& arguments, const std::string& stdoutFile,
            const std::vector<std::string>& more) {
  const Recorder out;
  const Recorder err;
  Redirections redirections;
  if (stdoutFile.empty())
    redirections.copy(out.descriptor(), STDOUT_FILENO);
  else
    redirections.open(STDOUT_FILENO, stdoutFile, O_WRONLY);
  redirections.copy(err.descriptor(), STDERR_FILENO);
  const int status = waitFor(start(arguments, redirections, more));
  return {status, out.text(), err.text()};
}

} // namespace

Outcome runProgram(const Arguments& arguments, const std::string& stdoutFile) {
  return run(arguments, stdoutFile, {});
}

Outcome runWith(const std::string& variable, const Arguments& arguments) {
  return run(arguments, {}, {variable});
}

Outcome runAndSignal(const Arguments& arguments, const std::string& text, int signal) {
  const int terminal = ::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
  require(terminal >= 0 && ::grantpt(terminal) == 0 && ::unlockpt(terminal) == 0,
          "there is no terminal to be had");
  const Recorder out;
  Redirections redirections;
  redirections.copy(out.descriptor(), STDOUT_FILENO);
  redirections.open(STDERR_FILENO, ::ptsname(terminal), O_WRONLY | O_NOCTTY);
  const pid_t child = start(arguments, redirections);
  Outcome outcome;
  bool isSent = false;
  std::array<char, 4096> block{};
  for (ssize_t got = 0; (got = ::read(terminal, block.data(), block.size())) > 0;) {
    outcome.err.append(block.data(), static_cast<std::size_t>(got));
    if (isSent || outcome.err.find(text) == std::string::npos) continue;
    ::kill(child, signal);
    isSent = true;
  }
  outcome.status = waitFor(child);
  outcome.out = out.text();
  ::close(terminal);
  return outcome;
}

std::string sample(const std::string& name) {
  return (sourceFolder() / "resources" / "samples" / name).string();
}

std::string bytesOf(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  require(in.good(), "a file that should be there is not");
  return {std::istreambuf_iterator<char>(in), {}};
}

nlohmann::json jsonIn(const std::filesystem::path& file) {
  return nlohmann::json::parse(bytesOf(file));
}

void writeBytes(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
}

std::vector<std::string> namesIn(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

void expectRefusal(const Outcome& outcome, int status, const std::vector<std::string>& parts) {
  EXPECT_EQ(outcome.status, status);
  EXPECT_THAT(outcome.out, testing::IsEmpty());
  EXPECT_THAT(outcome.err, testing::StartsWith("espalier: "));
  EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << outcome.err;
  for (const std::string& part : parts)
    EXPECT_THAT(outcome.err, testing::HasSubstr(part));
}

} // namespace espalier::test
