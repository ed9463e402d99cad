#pragma once

#include "app/window/frame/window_part.h"
#include "core/evaluate/differences/consensus.h"

#include <QString>

namespace espalier {

class ActionSet;
class JobSlot;
class PlantDocument;
class ProjectFlow;
class ReferenceFlow;

/// Leaves of the plant what it and its reference, the structure of another expert, agree on; what
/// it was before stays as a version, so that the rest can be decided place by place from both.
class ConsensusFlow : public WindowPart {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    PlantDocument& document;
    ProjectFlow& projects;
    ReferenceFlow& reference;
    JobSlot& jobs;
    ActionSet& actions;
  };
  explicit ConsensusFlow(const Parts& parts);

private:
  void find();
  void keep(const Consensus& consensus, const QString& other);
  [[nodiscard]] QString freeName(const QString& wanted) const; // of a version

  Parts parts_;
};

} // namespace espalier
