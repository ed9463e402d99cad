#pragma once

#include <QFrame>
#include <QTimer>

#include <array>
#include <functional>
#include <utility>
#include <vector>

class QBoxLayout;
class QLabel;
class QPushButton;

namespace espalier {

/// A button of a banner: its text and what it does.
struct BannerAction {
  QString text;
  std::function<void()> act;
};

/// A line over its parent that says what went wrong or what was done, until it is dismissed or the
/// next one comes; what was done leaves by itself. It hides as little as it can: it lies over the
/// foot of the parent, or where it covers less.
class MessageBanner : public QFrame {
  Q_OBJECT

public:
  explicit MessageBanner(QWidget* parent); // in no layout of it

  /// @param covered how much of what one looks at lies in a part of the parent
  void setCover(std::function<int(const QRect&)> covered) { covered_ = std::move(covered); }

  using Actions = std::vector<BannerAction>; // at most two

  void showError(const QString& text, const Actions& actions = {});
  void showOffer(const QString& text, const Actions& actions); // stays until it is answered
  /// @param action text of a button for `act`, as "Undo"; none if empty
  void showResult(const QString& text, const QString& action = {}, std::function<void()> act = {});

  /// Closes what would stay until it is answered, unanswered. @return whether there was one
  bool dismiss();

  [[nodiscard]] QString text() const;
  [[nodiscard]] bool isError() const;
  [[nodiscard]] bool leavesByItself() const { return leaves_.isActive(); }

signals:
  void shown(const QString& text);

private:
  bool eventFilter(QObject* watched, QEvent* event) override; // of the parent: it is resized
  void showText(const QString& kind, const QString& text, const Actions& actions);
  void place();
  /// With its text in one line and the buttons beside it, else below it, if there is room for that.
  [[nodiscard]] QSize sizeWithin(int width);

  QBoxLayout* row_;
  QLabel* text_;
  std::array<QPushButton*, 2> buttons_;
  QTimer leaves_;
  Actions actions_;
  std::function<int(const QRect&)> covered_;
};

} // namespace espalier
