#pragma once

#include "ui/document/canvas.h"
#include "ui/document/plant_document.h"
#include "ui/document/tool_input.h"

#include <QObject>
#include <QString>

#include <vector>

namespace espalier {

/// What the left button means in the 3D view: turns acts of the mouse into edits of the document.
///
/// It is given every act, also of gestures it did not take: the camera moves by those, and a tool
/// may still act on their release if the pointer has not moved (a click).
class Tool : public QObject {
  Q_OBJECT

public:
  /// Both must outlive it.
  explicit Tool(PlantDocument& document, Canvas& canvas, QObject* parent = nullptr)
      : QObject(parent), document_(document), canvas_(canvas) {}

  /// Returns true for what it took: a taken press keeps the camera still until the release.
  /// @throws Error if the act is refused; the document is as it was before the act
  bool handle(const ToolInput& input);

  /// What the mouse will do now, given what is under it, in parts with three spaces between them.
  /// A key is written as the id of its action in braces: "{new_child} new child".
  [[nodiscard]] virtual QString hint() const = 0;

  /// True in mid-gesture: then undo, Escape and other tools mean cancel().
  [[nodiscard]] virtual bool isBusy() const { return false; }

  /// Does it show what it would make, and wait for a yes? Its hint says "Enter accepts, Esc drops".
  [[nodiscard]] virtual bool hasPreview() const { return false; }

  /// Makes what the preview shows, as one edit. Called while there is a preview only.
  /// @throws Error if that is refused; the preview stays
  virtual void accept() {}

  /// Does Enter give it the node that is selected, if that is one alone?
  [[nodiscard]] virtual bool takesNodes() const { return false; }

  /// That node, as a click on it; the one that it was given last changes nothing.
  virtual void takeNode(NodeId /*id*/) {}

  /// What it has found, to be read and copied; Escape takes it away. Empty: nothing.
  [[nodiscard]] virtual QString result() const { return {}; }

  /// Leaves the gesture with nothing changed, and drops the preview.
  virtual void cancel() {}

  /// It is used from now on, while this is under the pointer.
  void enter(const Pick& under) { under_ = under; }

  /// Another tool is used now: takes away what it shows under the pointer.
  virtual void leave() {}

  /// What the tool works on until its next use, for one that is started from a node.
  virtual void startWith(const std::vector<NodeId>& /*nodes*/) {}

signals:
  void hintChanged();
  void finished(); // back to the tool used before

protected:
  [[nodiscard]] PlantDocument& document() const { return document_; }
  [[nodiscard]] Canvas& canvas() const { return canvas_; }
  [[nodiscard]] const Pick& under() const { return under_; }

private:
  virtual bool act(const ToolInput& input) = 0;

  PlantDocument& document_;
  Canvas& canvas_;
  Pick under_;
};

} // namespace espalier
