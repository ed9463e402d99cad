#pragma once

#include "core/cloud/point_set.h"
#include "core/graph/find_root.h"
#include "core/pipeline/registry.h"
#include "core/surface/envelopes/envelope.h"
#include "core/surface/envelopes/envelope_handles.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace espalier {

/// How an envelope that stands along z is set by its handles: see handlesOf(), draggedTo() and
/// withHandles() of the solid or hull that it is.
struct EnvelopeHandling {
  std::function<std::vector<EnvelopeHandle>(const Envelope&)> handles;
  std::function<HandlePlace(const Envelope&, const std::string& handle, const Eigen::Vector3d&)>
      draggedTo;
  std::function<Envelope(const Envelope&, const HandlePlaces&)> dragged;
};

/// One kind of crown envelope.
struct EnvelopeKind {
  /// Its name, texts and options, as methods of steps have them; it is no step, and has no run.
  Method form;
  /// `values`: one per option of the form, in order.
  std::function<Envelope(const Crown&, const std::vector<double>& values, const Progress&)> fit;
  bool hasFormula = false;               // for its volume
  std::vector<std::string> handles = {}; // the names of what can be dragged
  EnvelopeHandling handling = {};        // of a kind that has handles

  [[nodiscard]] bool hasHandles() const { return !handles.empty(); }
};

/// All of them: solids, then hulls of more and more freedom. Of each the first options are which
/// share of the points lies within (see crownOf), and from which height above the lowest on they
/// count [L].
[[nodiscard]] const std::vector<EnvelopeKind>& envelopeKinds();

/// @throws Error that lists the names there are
[[nodiscard]] const EnvelopeKind& envelopeKindNamed(std::string_view name);

/// The envelope of some points.
/// @param points 3 x N [L]
/// @return in the frame of the points, but for its azimuths: around `up`, from where x is once the
/// plant is turned upright (turnUpright)
/// @throws Error     if the points fill no space, or the kind says so
/// @throws Cancelled if `progress` asks to stop
[[nodiscard]] Envelope envelopeAbout(const Eigen::Matrix3Xd& points, UpAxis up,
                                     const EnvelopeKind& kind, const std::vector<double>& values,
                                     const Progress& progress = {});

/// What of an envelope can be dragged, in the frame of the points; nothing of kinds without
/// handles.
/// @param envelope  as envelopeAbout() or draggedEnvelope() gave it
[[nodiscard]] std::vector<EnvelopeHandle> envelopeHandles(const Envelope& envelope, UpAxis up,
                                                          const EnvelopeKind& kind);

/// Where a handle comes to stand that is dragged to `place`, once the plant is turned upright.
/// pre: the kind has such a handle
[[nodiscard]] HandlePlace draggedTo(const Envelope& envelope, UpAxis up, const EnvelopeKind& kind,
                                    const std::string& handle, const Eigen::Vector3d& place);

/// The envelope with handles where they were dragged to. Of the share of points inside it says
/// nothing: that was of the fitted one.
/// pre: the kind has handles
[[nodiscard]] Envelope draggedEnvelope(const Envelope& fitted, UpAxis up, const EnvelopeKind& kind,
                                       const HandlePlaces& places);

/// What envelopes are made about [L], frame of the file: points that were not set aside, or nodes.
[[nodiscard]] Eigen::Matrix3Xd placesOf(const PointCloud& cloud, const PointSet& leftOut);
[[nodiscard]] Eigen::Matrix3Xd placesOf(const Skeleton& skeleton);

/// Scale of a plant that has no points: its median edge, and its extent along the up axis.
[[nodiscard]] PlantScale scaleOf(const Skeleton& skeleton, UpAxis up);

/// The values of the options that are given as NAME=VALUE, and the defaults of the others.
/// @param meters of the unit of the plant, for values in mm, cm or m; 0: not known
/// @throws Error which names the option and what it takes
[[nodiscard]] std::vector<double> envelopeValues(const EnvelopeKind& kind,
                                                 const std::vector<std::string>& settings,
                                                 const PlantScale& scale, double meters);

} // namespace espalier
