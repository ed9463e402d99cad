#include "tests/app/window/asked_texts.h"

#include <QRegularExpression>
#include <gtest/gtest.h>

/// Not in a namespace, as the macro asks.
static void useTranslations() {
  Q_INIT_RESOURCE(translations);
}

namespace espalier::test {

AskedTexts::AskedTexts() {
  useTranslations();
  EXPECT_TRUE(french_.load("espalier_fr", ":/translations"));
}

QString AskedTexts::translate(const char* context, const char* source, const char* comment,
                              int n) const {
  if (source == nullptr || *source == '\0' || !isOwnContext(context)) return {};
  if (french_.translate(context, source, comment, n).isNull()) {
    const std::scoped_lock lock(mutex_);
    missing_[QString::fromUtf8(source)] = context;
  }
  return {};
}

QStringList AskedTexts::missing() const {
  const std::scoped_lock lock(mutex_);
  QStringList texts;
  for (auto each = missing_.begin(); each != missing_.end(); ++each)
    texts.append(each.value() + ": " + each.key());
  return texts;
}

bool isOwnContext(const QString& context) {
  static const QRegularExpression ofQt("^(Q[A-Z]|MAC_|CloseButton)");
  return !ofQt.match(context).hasMatch();
}

} // namespace espalier::test
