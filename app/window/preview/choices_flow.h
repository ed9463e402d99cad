#pragma once

#include "app/report/choice_record.h"
#include "app/window/frame/window_part.h"

#include <string>
#include <vector>

class QMenu;

namespace espalier {

class ActionSet;
class JudgeFlow;
class SweepFlow;

/// The record of how options were chosen: what was compared, in pictures and numbers, with the
/// project and in the report.
class ChoicesFlow : public WindowPart {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    ActionSet& actions;
    JudgeFlow& judge;
    SweepFlow& sweep;
  };
  explicit ChoicesFlow(const Parts& parts);

  [[nodiscard]] const std::vector<ChoiceRecord>& records() const { return records_; }

signals:
  void changed();

private:
  void record();
  void forgetLast();
  void set(std::vector<ChoiceRecord> records);

  Parts parts_;
  std::vector<ChoiceRecord> records_;
  std::string text_; // once made: projects ask for it often
};

} // namespace espalier
