#pragma once

#include <array>
#include <filesystem>

namespace espalier::test {

/// A driver of 3D mice, in place of spacenavd: libspnav of this process finds it while it lives.
class FakeSpacenavd {
public:
  explicit FakeSpacenavd(std::filesystem::path socket);
  ~FakeSpacenavd();
  FakeSpacenavd(const FakeSpacenavd&) = delete;
  FakeSpacenavd& operator=(const FakeSpacenavd&) = delete;

  void accept(); // who has connected
  /// x, y, z, and turns about them; and the time since the event before [ms].
  void move(const std::array<int, 6>& axes, int period);
  void press(int button);
  void release(int button);

private:
  void send(const std::array<int, 8>& event) const;

  std::filesystem::path path_;
  int listening_;
  int client_ = -1;
};

} // namespace espalier::test
