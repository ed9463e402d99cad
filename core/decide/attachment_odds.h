#pragma once

#include "core/base/quadratic.h"
#include "core/decide/attachment_links.h"

#include <array>
#include <vector>

namespace espalier {

/// What the probability of an attachment follows from: its lengths by their logarithms.
[[nodiscard]] std::array<double, 16> featuresOf(const AttachmentEvidence& evidence);

/// Whose value is the logarithm of how probable a place is beside others that the same wood may
/// grow from, of a conditional logit, as GapOdds.
using AttachmentOdds = Quadratic<16>;

/// The odds that are fitted: by espalier_fit_attachments (tests/bench/fit_attachments.cpp) on
/// simulated scans.
[[nodiscard]] const AttachmentOdds& fittedAttachmentOdds();

/// How probable it is of each link of a choice, in (0, 1), that the wood grew so: they add up to 1.
[[nodiscard]] std::vector<double>
probabilitiesOf(const AttachmentChoice& choice,
                const AttachmentOdds& odds = fittedAttachmentOdds());

} // namespace espalier
