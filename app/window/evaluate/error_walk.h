#pragma once

#include "core/evaluate/evaluation.h"

#include <QObject>
#include <QString>

#include <functional>
#include <memory>
#include <vector>

class QWidget;

namespace espalier {

class ActionSet;
class DifferencesPanel;
class Editing;
class IgnoringSteps;
class JobSlot;
class PlantDocument;
class PlantView;

/// Walks from error to error of a comparison: flies to each, ignores it, or makes the plant there
/// what the reference is.
class ErrorWalk : public QObject {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    PlantDocument& document;
    PlantView& view;
    JobSlot& jobs;
    ActionSet& actions;
    Editing& editing;
    IgnoringSteps& ignoring;
    std::function<QString()> version; // that it is compared with; empty: with another structure
  };
  explicit ErrorWalk(Parts parts);

  [[nodiscard]] DifferencesPanel* panel() const { return panel_; }
  void show(std::shared_ptr<const Evaluation> evaluation); // null: there is none
  [[nodiscard]] const std::vector<DifferingPart>& ignored() const { return ignored_; }
  void setIgnored(std::vector<DifferingPart> ignored);
  [[nodiscard]] static QStringList menu(); // ids of its actions

signals:
  void noted(const QString& message);
  void ignoredChanged();
  void shownAsked(); // the panel is to be seen

private:
  void addActions();
  void list();
  [[nodiscard]] bool isIgnored(const DifferingPart& part) const;
  void ignoreOnly(const std::vector<DifferingPart>& parts); // and notes it
  void step(int by);
  void goTo(const DifferingPart& part);
  void mark(const std::optional<DifferingPart>& part);
  /// @throws Error if there is none
  [[nodiscard]] DifferingPart chosen() const;
  void accept();
  void toggleIgnored();
  void showActions();

  Parts parts_;
  DifferencesPanel* panel_;
  std::shared_ptr<const Evaluation> evaluation_;
  std::vector<DifferingPart> done_; // accepted since it was compared
  std::vector<DifferingPart> ignored_;
};

} // namespace espalier
