#pragma once

#include "core/evaluate/scores.h"

#include <QString>
#include <QtGlobal>

#include <optional>
#include <string>
#include <vector>

namespace espalier {

/// A structure in the table of methods.
struct KeptMethod {
  QString path;                      // of its file
  std::optional<ScoreValues> scores; // none: not compared, or not by what is compared now
  qint64 written = 0;                // when the file that they are of was [ms since 1970]

  bool operator==(const KeptMethod&) const = default;
};

/// As a project keeps them: [{"path": "...", "written": ms, "scores": {"f": 0.9, ...}}, ...], null
/// for what is not known. Empty without any.
[[nodiscard]] std::string textOf(const std::vector<KeptMethod>& methods);

/// Scores that this version does not know are left out; of a structure that lacks one which it does
/// know, all are, so that it is compared again.
/// @throws Error if it is no such text
[[nodiscard]] std::vector<KeptMethod> methodsFrom(const std::string& text);

} // namespace espalier
