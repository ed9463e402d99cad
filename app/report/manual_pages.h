#pragma once

#include <QByteArray>
#include <QString>

#include <vector>

namespace espalier {

/// A file of the manual as web pages.
struct ManualPage {
  QString file; // "index.html", "files.html", "editor.png"
  QByteArray bytes;
};

/// The manual as web pages: one for each chapter, with the list of chapters on each, and the
/// pictures. The pages fetch nothing from elsewhere, fit a phone and paper, are light or dark as
/// the reader's system is, and are well-formed as XML. The first is index.html.
/// pre: there is a QGuiApplication, whose fonts Qt reads Markdown with
[[nodiscard]] std::vector<ManualPage> manualPages();

} // namespace espalier
