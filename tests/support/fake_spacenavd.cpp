#include "tests/support/fake_spacenavd.h"

#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>
#include <utility>

namespace espalier::test {
namespace {

enum DriverEvent { motion, pressed, released }; // of the protocol

} // namespace

FakeSpacenavd::FakeSpacenavd(std::filesystem::path socket)
    : path_(std::move(socket)), listening_(::socket(AF_UNIX, SOCK_STREAM, 0)) {
  sockaddr_un address = {};
  address.sun_family = AF_UNIX;
  path_.string().copy(address.sun_path, sizeof address.sun_path - 1);
  std::filesystem::remove(path_);
  const bool isThere =
      ::bind(listening_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0 &&
      ::listen(listening_, 1) == 0;
  if (!isThere) throw std::runtime_error("no socket at " + path_.string());
  ::setenv("SPNAV_SOCKET", path_.c_str(), 1);
}

FakeSpacenavd::~FakeSpacenavd() {
  if (client_ >= 0) ::close(client_);
  ::close(listening_);
  std::filesystem::remove(path_);
  ::unsetenv("SPNAV_SOCKET");
}

void FakeSpacenavd::accept() {
  client_ = ::accept(listening_, nullptr, nullptr);
}

void FakeSpacenavd::move(const std::array<int, 6>& axes, int period) {
  send({motion, axes[0], axes[1], axes[2], axes[3], axes[4], axes[5], period});
}

void FakeSpacenavd::press(int button) {
  send({pressed, button});
}

void FakeSpacenavd::release(int button) {
  send({released, button});
}

void FakeSpacenavd::send(const std::array<int, 8>& event) const {
  if (::send(client_, event.data(), sizeof event, MSG_NOSIGNAL) != sizeof event)
    throw std::runtime_error("nobody has connected");
}

} // namespace espalier::test
