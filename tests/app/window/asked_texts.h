#pragma once

#include <QMap>
#include <QString>
#include <QStringList>
#include <QTranslator>

#include <mutex>

namespace espalier::test {

/// Notes each text of the program that the window asks for and the French translation lacks: where
/// lupdate finds a text in another class than the running program, or not at all. Translates
/// nothing.
class AskedTexts : public QTranslator {
public:
  AskedTexts();

  [[nodiscard]] bool isEmpty() const override { return false; }
  [[nodiscard]] QString translate(const char* context, const char* source, const char* comment,
                                  int n) const override;
  [[nodiscard]] QStringList missing() const;

private:
  QTranslator french_;
  mutable std::mutex mutex_; // jobs make texts, too
  mutable QMap<QString, QString> missing_;
};

/// Whether a class is of this program, not of Qt.
[[nodiscard]] bool isOwnContext(const QString& context);

} // namespace espalier::test
