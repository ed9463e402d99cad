#pragma once

#include <cstdint>
#include <string>

namespace espalier {

enum class ReviewState : std::uint8_t { toDo, doubtful, reviewed };

/// What an expert who looked at a node says of it and of its edge to the parent. Never exported.
struct ReviewMark {
  ReviewState state = ReviewState::toDo;
  std::string comment = {};
  std::string reviewer = {}; // who set the state; empty while to do

  bool operator==(const ReviewMark&) const = default;
};

} // namespace espalier
