#pragma once

#include "core/project/seal.h"
#include "ui/document/length_unit.h"

#include <QString>

#include <vector>

namespace espalier {

/// What a seal says, as a dialog, a panel and a certificate show it: what it is of, and the text.
struct SealRow {
  QString name;
  QString text;
};

/// The structure, the work, how it was reviewed, what was open, and how it agrees with others; what
/// is not known is left out.
[[nodiscard]] std::vector<SealRow> sealRows(const Seal& seal, LengthUnit unit);

/// "12 open (bare twigs: 10, sharp turns: 2); 3 ignored" or "none is open"
[[nodiscard]] QString findingsText(const SealedState& state);

/// "Anna on 21 Nov 2026, 14:05", in the time of the place
[[nodiscard]] QString signatureOf(const Seal& seal);

} // namespace espalier
