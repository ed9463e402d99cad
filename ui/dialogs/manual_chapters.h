#pragma once

#include <QByteArray>
#include <QString>

#include <vector>

namespace espalier {

/// A chapter of the manual.
struct ManualChapter {
  QString file;  // "first-plant.md": how links name it
  QString title; // its first heading
  QString text;  // Markdown, with the tables of methods and options
};

/// All chapters, in their order; those that there are in this language ("fr") in it, the others in
/// English. The first is the page that lists them, README.md: from its links
/// the order is taken. A chapter that it lists and that is not there is left out, as is its line.
[[nodiscard]] std::vector<ManualChapter> manualChaptersIn(const QString& language);

/// The same in the language that the window had when it was asked for first.
[[nodiscard]] const std::vector<ManualChapter>& manualChapters();

/// The picture of this name; empty: there is none.
[[nodiscard]] QByteArray manualPicture(const QString& name);

/// How a link names a heading: "mtg-files" of "MTG files", as GitHub does.
[[nodiscard]] QString manualAnchor(const QString& heading);

} // namespace espalier
