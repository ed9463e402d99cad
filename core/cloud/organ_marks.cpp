#include "core/cloud/organ_marks.h"

#include <algorithm>

namespace espalier {

bool OrganMarks::isEmpty() const {
  return std::ranges::all_of(sets_, &PointSet::isEmpty);
}

PointSet OrganMarks::all() const {
  PointSet all;
  for (const PointSet& set : sets_)
    all = all | set;
  return all;
}

OrganMarks OrganMarks::with(const PointSet& points, std::optional<Organ> organ) const {
  OrganMarks result = *this;
  for (PointSet& set : result.sets_)
    set = set - points;
  if (organ) {
    PointSet& set = result.sets_[static_cast<std::size_t>(*organ)];
    set = set | points;
  }
  return result;
}

OrganMarks OrganMarks::operator^(const OrganMarks& other) const {
  OrganMarks result;
  for (std::size_t i = 0; i < sets_.size(); ++i)
    result.sets_[i] = sets_[i] ^ other.sets_[i];
  return result;
}

} // namespace espalier
