#include "ui/view/space_mouse.h"

#include <QFileInfo>
#include <QSocketNotifier>

#include <algorithm>
#include <spnav.h>
#include <sys/socket.h>

namespace espalier {
namespace {

constexpr double farthest = 350;  // of an axis
constexpr unsigned longest = 100; // [ms] between events: a longer pause is no push

Steering steeringOf(const spnav_event_motion& motion) {
  const double much = std::min(motion.period, longest) / 1000.0 / farthest;
  return {.shift = much * Eigen::Vector3d(motion.x, motion.y, motion.z),
          .turn = much * Eigen::Vector2d(motion.rx, motion.ry)};
}

/// Whether a driver may be there, where libspnav looks: each of its tries in vain keeps memory.
bool mayHaveDriver() {
  return qEnvironmentVariableIsSet("SPNAV_SOCKET") || QFileInfo::exists("/etc/spnavrc") ||
         QFileInfo::exists("/var/run/spnav.sock");
}

/// The driver has ended, or was stopped.
bool isClosed(int socket) {
  char byte = 0;
  return recv(socket, &byte, 1, MSG_PEEK | MSG_DONTWAIT) == 0;
}

} // namespace

SpaceMouse::SpaceMouse(QObject* parent) : QObject(parent) {}

SpaceMouse::~SpaceMouse() {
  disconnectFromDriver();
}

void SpaceMouse::connectToDriver() {
  if (isConnected() || !mayHaveDriver() || spnav_open() == -1) return;
  events_ = std::make_unique<QSocketNotifier>(spnav_fd(), QSocketNotifier::Read);
  connect(events_.get(), &QSocketNotifier::activated, this, &SpaceMouse::take);
}

void SpaceMouse::disconnectFromDriver() {
  if (!isConnected()) return;
  events_.reset();
  spnav_close();
}

void SpaceMouse::take() {
  if (isClosed(spnav_fd())) {
    events_->setEnabled(false);
    events_.release()->deleteLater(); // it is in its signal
    spnav_close();
    return;
  }
  Steering sum;
  spnav_event event = {};
  while (const int type = spnav_poll_event(&event)) {
    if (type == SPNAV_EVENT_BUTTON && event.button.press != 0) emit pressed(event.button.bnum);
    if (type != SPNAV_EVENT_MOTION) continue;
    const Steering by = steeringOf(event.motion);
    sum.shift += by.shift;
    sum.turn += by.turn;
  }
  const bool isHeld = !sum.shift.isZero() || !sum.turn.isZero();
  if (isHeld) emit steered(sum); // once for all that has come meanwhile
}

} // namespace espalier
