#pragma once

#include <array>
#include <cstdint>

namespace espalier {

/// What a point of a plant lies on. Stems of herbs and grasses count as wood.
enum class Organ : std::uint8_t { wood, petiole, blade, needle };

inline constexpr std::array allOrgans = {Organ::wood, Organ::petiole, Organ::blade, Organ::needle};

} // namespace espalier
