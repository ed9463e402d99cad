#include "app/window/frame/theme.h"

#include <QApplication>
#include <QFile>
#include <QStyle>
#include <QStyleFactory>

namespace espalier {
namespace {

QPalette paletteOf(const ThemeColors& colors) {
  QPalette palette(colors.text, colors.button, colors.button.lighter(120),
                   colors.border.darker(120), colors.border, colors.text, colors.text, colors.field,
                   colors.panel);
  palette.setColor(QPalette::Highlight, colors.primary);
  palette.setColor(QPalette::HighlightedText, colors.onPrimary);
  palette.setColor(QPalette::PlaceholderText, colors.quiet);
  palette.setColor(QPalette::Link, colors.accent);
  palette.setColor(QPalette::ToolTipBase, colors.field);
  palette.setColor(QPalette::ToolTipText, colors.text);
  palette.setColor(QPalette::AlternateBase, colors.panel);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    QColor faint = colors.text;
    faint.setAlphaF(0.38F);
    palette.setColor(QPalette::Disabled, role, faint);
  }
  return palette;
}

QString styleSheetOf(const ThemeColors& colors, bool dark) {
  QFile file(QStringLiteral(":/style/window.qss"));
  const bool isThere = file.open(QIODevice::ReadOnly);
  Q_ASSERT(isThere);
  QString sheet = isThere ? QString::fromUtf8(file.readAll()) : QString();
  const auto put = [&](const char* name, const QColor& color) {
    sheet.replace(QString("@%1;").arg(name), color.name() + ";");
  };
  put("panel", colors.panel);
  put("field", colors.field);
  put("button", colors.button);
  put("hover", colors.hover);
  put("border", colors.border);
  put("text", colors.text);
  put("quiet", colors.quiet);
  put("accent", colors.accent);
  put("primary", colors.primary);
  put("on-primary", colors.onPrimary);
  put("error", colors.error);
  put("on-error", colors.onError);
  const QString ground = dark ? QStringLiteral("dark") : QStringLiteral("light");
  for (const char* icon : {"chevron", "check"})
    sheet.replace(QString("@%1;").arg(icon),
                  QString("url(:/style/%1_on_%2.svg);").arg(icon, ground));
  return sheet;
}

} // namespace

QString nameOf(Theme theme) {
  switch (theme) {
  case Theme::light:
    return QStringLiteral("light");
  case Theme::dark:
    return QStringLiteral("dark");
  case Theme::system:
    break;
  }
  return QStringLiteral("system");
}

Theme themeNamed(const QString& name) {
  if (name == "light") return Theme::light;
  return name == "dark" ? Theme::dark : Theme::system;
}

ThemeColors themeColors(bool dark) {
  if (dark)
    return {.panel = "#23262a",
            .field = "#1b1d20",
            .button = "#2f3338",
            .hover = "#393e44",
            .border = "#3b4046",
            .text = "#e6e9e6",
            .quiet = "#a6aea9",
            .accent = "#5cc48d",
            .primary = "#5cc48d",
            .onPrimary = "#0d2216",
            .error = "#4a2a22",
            .onError = "#ffd9cc"};
  return {.panel = "#f6f7f5",
          .field = "#ffffff",
          .button = "#ffffff",
          .hover = "#e8ebe7",
          .border = "#d3d8d2",
          .text = "#20251f",
          .quiet = "#5c655e",
          .accent = "#2f8f5b",
          .primary = "#2a8052", // the accent, dark enough for white text
          .onPrimary = "#ffffff",
          .error = "#fbe6de",
          .onError = "#6d2408"};
}

bool isSystemDark() {
  const QPalette ours = QApplication::palette();
  const bool isOurs = ours.resolveMask() != 0;
  if (isOurs) QApplication::setPalette(QPalette()); // nothing set: that of the system shows
  const bool isDark = QApplication::palette().color(QPalette::Window).lightness() < 128;
  if (isOurs) QApplication::setPalette(ours);
  return isDark;
}

void applyTheme(bool isDark) {
  const ThemeColors colors = themeColors(isDark);
  const QString sheet = styleSheetOf(colors, isDark);
  auto& program = *static_cast<QApplication*>(QCoreApplication::instance());
  if (program.styleSheet() == sheet) return; // each of these goes over all widgets
  QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
  QApplication::setPalette(paletteOf(colors));
  program.setStyleSheet(sheet);
}

} // namespace espalier
