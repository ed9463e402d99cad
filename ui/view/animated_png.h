#pragma once

#include <QImage>
#include <QSize>

#include <cstdint>
#include <iosfwd>

namespace espalier {

/// Writes pictures of one size as an animated PNG that plays over and over: lossless, in all
/// colors. Browsers play it; programs that know PNG alone show the first picture.
/// Source: APNG specification 1.0, since 2025 part of PNG (Third Edition).
class AnimatedPng {
public:
  /// @param out       must outlive it
  /// @param frames    how many will be added, > 0
  /// @param perSecond pictures shown a second, > 0
  AnimatedPng(std::ostream& out, std::uint32_t frames, std::uint16_t perSecond)
      : out_(out), frames_(frames), perSecond_(perSecond) {}

  /// pre: fewer than `frames` were added, all of this size
  void add(const QImage& frame);

private:
  void writeControl(const QSize& size);

  std::ostream& out_;
  std::uint32_t frames_;
  std::uint16_t perSecond_;
  std::uint32_t added_ = 0;
  std::uint32_t sequence_ = 0; // of chunks
};

} // namespace espalier
