#pragma once

#include <QGuiApplication>
#include <QTemporaryDir>

#include <array>
#include <memory>
#include <string>

namespace espalier {

/// The application that Qt draws with, without a display. One at a time; only what draws makes it,
/// since it takes a while to start.
class Headless {
public:
  Headless();

private:
  QTemporaryDir folder_; // Qt wants one to run in
  int argc_ = 1;
  std::string name_ = "espalier";
  std::array<char*, 2> argv_{name_.data(), nullptr};
  std::unique_ptr<QGuiApplication> application_;
};

} // namespace espalier
