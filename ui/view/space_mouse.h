#pragma once

#include "ui/view/navigator.h"

#include <QObject>

#include <memory>

class QSocketNotifier;

namespace espalier {

/// A 3D mouse: a cap that is pushed and turned. It is reached through the driver spacenavd, by
/// libspnav (https://spacenav.sourceforge.net); without a driver there is none.
class SpaceMouse : public QObject {
  Q_OBJECT

public:
  explicit SpaceMouse(QObject* parent = nullptr);
  ~SpaceMouse() override;

  /// Looks for the driver, unless it is found. A process has one connection. Takes under a
  /// millisecond; 0.3 s with drivers before 1.0, once.
  void connectToDriver();
  [[nodiscard]] bool isConnected() const { return events_ != nullptr; }

signals:
  void steered(const espalier::Steering& by);
  void pressed(int button); // from 0 on

private:
  void take();
  void disconnectFromDriver();

  std::unique_ptr<QSocketNotifier> events_; // null: there is no driver
};

} // namespace espalier
