#pragma once

#include "core/cloud/point_cloud.h"
#include "core/skeleton/skeleton.h"
#include "core/skeleton/skeleton_delta.h"
#include "ui/document/canvas.h"
#include "ui/document/tool_input.h"
#include "ui/view/attachment_overlay.h"
#include "ui/view/camera.h"
#include "ui/view/clip.h"
#include "ui/view/close_look.h"
#include "ui/view/envelope_overlay.h"
#include "ui/view/focus.h"
#include "ui/view/ghost_overlay.h"
#include "ui/view/hull_overlay.h"
#include "ui/view/in_view.h"
#include "ui/view/navigator.h"
#include "ui/view/node_look.h"
#include "ui/view/plant_state.h"
#include "ui/view/point_colors.h"
#include "ui/view/point_look.h"
#include "ui/view/shown_scan.h"
#include "ui/view/sight_overlay.h"

#include <QImage>
#include <QString>
#include <QWidget>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace espalier {

class Turntable; // turntable.h
struct TurntableOptions;

enum class Layer { points, contracted, skeleton, reference };

/// The 3D view of a plant: its points, its contracted points, its skeleton, and the reference that
/// this is compared with.
///
/// Mirrors what it is given and owns no plant data; it never edits. The mouse goes first to the
/// input handler; what that does not take turns (left), pans (right) and zooms (middle, wheel) the
/// camera, and a double click sets the pivot. With Ctrl alone all goes to the camera.
///
/// Moves of the camera that are asked for by function take 200 ms while the view is seen, and are
/// at their end at once while it is not.
class PlantView : public QWidget, public Canvas {
  Q_OBJECT

public:
  explicit PlantView(QWidget* parent = nullptr);
  /// Another view of what `first` shows, now and later, from a camera of its own. What is set of
  /// the plant in one is set in all; color bars are in the first. Both must be in one window.
  PlantView(const PlantView& first, QWidget* parent);
  ~PlantView() override;

  void setCloud(std::shared_ptr<const PointCloud> cloud); // null: none; does not move the camera
  /// Points of the cloud that no bounds, colors by value or overview follow, until setCloud().
  /// Which are drawn is up to setPointStates(). O(points).
  void setPointsLeftOut(const PointSet& points);
  void setContracted(std::shared_ptr<const Eigen::Matrix3Xf> positions); // as cloud positions
  void setSkeleton(const Skeleton& skeleton);
  /// Redraws what an edit changed. Cost follows the size of the edit.
  void updateSkeleton(const Skeleton& skeleton, const SkeletonDelta& delta);
  void setSelection(const std::vector<NodeId>& nodes);
  /// Drawn dotted behind the skeleton, and never picked. Forgets its colors and marks.
  void setReference(const Skeleton& reference);              // empty: none
  void setReferenceColors(std::optional<NodeColors> colors); // none: all alike
  void setReferenceSelection(const std::vector<NodeId>& nodes);
  /// Shows another state of the plant on a side of the divider, where nothing of the plant itself
  /// is picked then; none: the plant itself. Until setCloud().
  void setState(Side side, const std::optional<PlantState>& state);
  /// Where this view is divided, as part of its width. 1, as at first: all of it is the left side.
  void setDivider(double across);
  [[nodiscard]] double divider() const;
  /// Draws another scan over the cloud, each in a color of its own; none: the cloud as ever.
  void setMovedScan(const std::optional<ShownScan>& scan);
  /// Draws contracted points between where they were scanned, 0, and where they are, 1,
  /// in place of the points; none: both layers where they are.
  void setBlend(std::optional<double> blend);
  void setDisplacementsShown(bool areShown);              // a line for each, of some 30 000 at most
  void showSight(const std::optional<ShownSight>& sight); // over the plant; none: nothing
  [[nodiscard]] const std::optional<ShownSight>& sightShown() const;
  void setHovered(const Pick& pick);
  void hoverAgain(); // gives the handler what lies under the resting pointer now

  /// How nodes look, each with the edge to its parent, until setSkeleton(): as SkeletonGlyphs.
  void setHiddenNodes(const std::vector<NodeId>& nodes); // nor picked, nor in an area
  void setNodeColors(std::optional<NodeColors> colors);  // none: by the type of the edge
  void setFaded(const std::optional<std::vector<NodeId>>& allBut);

  /// How the points of the cloud look, until setCloud(). O(points).
  /// pre: one per point of the cloud; null or none: as usual
  void setPointStates(std::shared_ptr<const std::vector<PointState>> states);
  void setPointValues(std::optional<PointValues> values); // in place of the point color

  /// On which scales values are colored. The handles of a color bar choose its range, too.
  void setColorScales(const ColorScales& scales);
  [[nodiscard]] const ColorScales& colorScales() const;
  bool typeColorRange(); // in a field at the first color bar; false if none is shown

  /// Shows, picks and finds in areas only what is in the clip. At first: all.
  void setClip(const Clip& clip);
  [[nodiscard]] const Clip& clip() const;
  /// Handles with which the mouse drags the faces of the clip's box and the planes of its slab.
  void setClipHandlesShown(bool areShown); // at first: not
  void setDepthFade(double strength);      // [0, 1]: how far the back of the plant steps back
  [[nodiscard]] double depthFade() const;
  /// How far what is neither near what one flew to in depth nor of its branch steps back, in
  /// [0, 1]; at first 0.7. It ends where all of the plant is framed, or focusOff() is called.
  void setFocusFade(double strength);
  [[nodiscard]] double focusFade() const;
  void focusOff();
  [[nodiscard]] Eigen::AlignedBox3d bounds() const; // of all there is [L]; empty: nothing

  void setLayerVisible(Layer layer, bool visible);
  void setPointColor(PointColor color);
  /// Colors of points by height or intensity span what is seen, where that is a part of the plant
  /// and no range was chosen by hand: anew once the view has settled. At first: on.
  void setColorsSpanSeen(bool doSpan);
  void setPointSize(int pixels);               // 1 to 10
  void setShowRadii(bool trueRadii);           // edges as frusta of their radius instead of lines
  void setHulls(std::vector<ShownHull> hulls); // painted over the plant
  /// Painted over the plant, as glass; its handles can be dragged. None: nothing.
  void setEnvelope(std::optional<ShownEnvelope> envelope);
  /// Likewise, with the layer of the reference, until setReference(); none: nothing.
  void showAttachment(const std::optional<ShownAttachment>& attachment);
  void showGhosts(std::vector<ShownGhost> ghosts); // over the plant, with their numbers; none
  void setProjection(Projection projection);
  /// Draws the plant for each eye, for glasses of red and cyan: see redCyan(). At first: not.
  void setStereo(bool isStereo);
  void setDark(bool dark);
  void setMinimapShown(bool isShown);      // in views that are large enough; at first: not
  void setLengthUnit(const QString& unit); // written at scales; empty: not known
  /// The axis of the file along which the plant stands, and heights are. At first: z.
  void setUp(UpAxis up);
  /// The place that was chosen for the root [L]: a square with a label; none: nothing.
  void setRootMark(const std::optional<Eigen::Vector3d>& place);

  void frameAll();
  void faceAll();                             // likewise, and as Camera::faceBroadside()
  void frame(const Eigen::AlignedBox3d& box); // [L], frame of the file
  void look(StandardView view);
  void setPivot(const Eigen::Vector3d& place);       // [L], what the camera turns around
  [[nodiscard]] const Camera& camera() const;        // where it is, or will be once it has arrived
  [[nodiscard]] const Camera& currentCamera() const; // where it is
  void setCamera(const Camera& camera);              // at once
  void flyTo(const Camera& camera);                  // as look()
  /// Likewise; what is neither near the focus in depth nor of its branch steps back.
  void flyTo(const Camera& camera, const std::optional<Focus>& focus);
  /// From where a part of the plant is seen best; of one that was asked for before, and has not
  /// been moved, the same as then. pre: the sight is not empty
  [[nodiscard]] Camera cameraToSee(const Sight& sight) const;

  void steer(const Steering& by); // its camera, by a 3D mouse; not in mid-gesture

  /// Is the view at rest: nothing moves, and all points are drawn? (Never, before it is shown.)
  [[nodiscard]] bool isStill() const;
  /// How often it was drawn with its camera where it was to be, be it with few points.
  [[nodiscard]] int framesAtRest() const;

  /// Returns true for what it took: a taken press keeps the camera still until the release or a
  /// cancel (Escape, or the keyboard goes elsewhere). It is given the drags and the release of
  /// gestures it did not take as well, while they move the camera, since one that has not moved is
  /// a click; but nothing with Ctrl alone. Such drags, and the hover that is sent when the pointer
  /// leaves the view, have an empty pick.
  using InputHandler = std::function<bool(const ToolInput&)>;
  void setInputHandler(InputHandler handler);
  /// Whether the pointer, and areas drawn with it, take what is hidden behind wood. At first: no.
  void setDepth(Depth depth);

  /// What is within reach of the pointer at `position`, in logical pixels.
  [[nodiscard]] Pick pick(const QPointF& position) const;
  [[nodiscard]] std::vector<NodeId> nodesInside(const QPolygonF& area, Depth depth) const override;
  [[nodiscard]] std::vector<Eigen::Index> pointsInside(const QPolygonF& area,
                                                       Depth depth) const override;
  /// All points that are shown, on the screen or not: not hidden, and in the clip. O(points).
  [[nodiscard]] std::vector<Eigen::Index> pointsShown() const;
  /// How many of some thousand places all over the plant are drawn in a part of the view.
  [[nodiscard]] int coveredBy(const QRect& part) const;
  [[nodiscard]] std::optional<QPointF> project(const Eigen::Vector3d& place) const override;
  void showBand(const QPolygonF& band) override;
  void showPreview(const Preview& preview) override;

  /// The view as it would be drawn at `size`, all points, no pointer, no band and no preview.
  /// @param pixelRatio as of espalier::picture()
  [[nodiscard]] QImage picture(const QSize& size, double pixelRatio = 1);
  /// The plant as picture() shows it, to be turned. @throws Error if there is no OpenGL
  [[nodiscard]] std::unique_ptr<Turntable> turntable(const TurntableOptions& options) const;
  enum class Framing : std::uint8_t {
    whole,
    asSeen
  }; // all of the plant, or the middle of the view
  /// Another state of the plant as this view would draw it, without legends and names.
  [[nodiscard]] QImage pictureOf(const PlantState& state, const QSize& size, Framing framing) const;
  /// The same for paper, whatever is shown here: on light ground, the contracted points in one
  /// color, or without them those scanned, with the skeleton and nothing else.
  [[nodiscard]] QImage paperOf(const PlantState& state, const QSize& size, Framing framing) const;
  [[nodiscard]] std::size_t graphicsBytes() const; // that all views of the plant hold together

  /// Whether the view shows anything of the plant, as it is now.
  [[nodiscard]] InView inView() const;
  void setWord(const QString& word); // in the middle of the view; empty: none

signals:
  void settled(); // what is shown, and from where, has not changed for a moment
  void cameraMoved(const espalier::Camera& camera); // to where it is now
  void dividerMoved(double across);                 // by hand
  // Emitted by the first view of a plant:
  void clipChanged();                                      // or how far the back steps back
  void colorScalesChanged();                               // by hand
  void envelopeHovered(std::optional<std::size_t> handle); // none: no longer
  void envelopePressed();                                  // one of its handles
  void envelopeDragged(std::size_t handle, const Eigen::Vector3d& to); // [L]
  void envelopeReleased();
  void envelopeGivenBack(); // Escape, or the keyboard goes elsewhere, in mid-drag

protected:
  bool event(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void enterEvent(QEnterEvent* event) override;
  void leaveEvent(QEvent* event) override;

private:
  [[nodiscard]] bool isInGesture() const; // which Escape ends
  // Whether the handles of the clip took the event; plant_view_clip.cpp
  bool pressClip(const QMouseEvent& event);
  bool moveClip(const QMouseEvent& event);
  bool releaseClip(const QMouseEvent& event);
  // Whether the handles of the envelope did; plant_view_envelope.cpp
  bool pressEnvelope(const QMouseEvent& event);
  bool moveEnvelope(const QMouseEvent& event);
  bool releaseEnvelope(const QMouseEvent& event);

  struct Shared;
  struct Parts;
  PlantView(std::shared_ptr<Shared> shared, QWidget* parent);
  std::unique_ptr<Parts> parts_;
};

} // namespace espalier
