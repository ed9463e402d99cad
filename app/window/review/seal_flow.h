#pragma once

#include "app/window/files/report_maker.h"
#include "app/window/frame/window_part.h"
#include "app/window/review/sealed_facts.h"
#include "core/project/seal.h"
#include "core/project/structure_hash.h"

#include <QString>

#include <functional>
#include <optional>

class QMainWindow;

namespace espalier {

class ActionSet;
class JobSlot;
class MessageBanner;
class PlantDocument;
class ProjectFlow;

/// The seal of a structure: signing it, keeping it in the project, its certificate, and warning
/// when it breaks.
///
/// Before a name is asked for, a job finds what the seal states: what the checks find, and how the
/// structure agrees with the reconstruction and with the reference.
///
/// Whether it holds is a matter of the structure alone: undo or redo to what was signed mends it.
class SealFlow : public WindowPart {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    PlantDocument& document;
    ActionSet& actions;
    ProjectFlow& projects;
    JobSlot& jobs;
    MessageBanner& banner;
    QMainWindow& window;
    std::function<void(ToSeal&)> addKnown; // limits, findings and reference of the window
    std::function<bool(const Finding&)> isIgnored;
    std::function<SealedQuestions()> questions;
  };
  explicit SealFlow(const Parts& parts);

  void setEnabled(bool isEnabled) override;
  void setSigner(const QString& name) { signer_ = name; }
  [[nodiscard]] bool isSigned() const { return seal_.has_value(); }
  [[nodiscard]] bool isIntact() const { return seal_ && hash_->value() == seal_->hash; }
  [[nodiscard]] QString text() const; // what the panel says of it

signals:
  void changed();                          // text() has
  void signerChanged(const QString& name); // typed where it was signed

private:
  void sign();
  void requireReviewed(const Skeleton& plant) const;
  void askToSign(SealedFacts facts);
  void requireIntact() const;
  void exportSeal();
  void chooseCertificate();
  void writeCertificate(const QString& path);
  void set(std::optional<Seal> seal);
  void follow(); // a step was done or undone
  void warnOfBreak();
  void goToSigned();
  /// How many steps are done where the structure is what was signed; none: no more of them leads
  /// there. Time O(changes of all steps).
  [[nodiscard]] std::optional<int> signedStep() const;
  [[nodiscard]] bool isBeforeSigned() const; // by undo: redo leads there
  void refresh();

  Parts parts_;
  ReportMaker maker_; // of the certificate
  QString signer_;
  std::optional<Seal> seal_;
  std::optional<StructureHash> hash_; // of the skeleton now, once there is a seal
  bool couldReturn_ = false;          // undo or redo led to what was signed
  bool wasIntact_ = false;
  QString warning_; // in the banner, that it broke
  bool isEnabled_ = true;
};

} // namespace espalier
