#pragma once

#include <cstddef>
#include <list>
#include <utility>

namespace espalier {

/// The last few results, each under what it was computed from. The one least recently asked for
/// goes first.
template <class Key, class Value> class Recent {
public:
  static constexpr std::size_t most = 4;

  /// None if it is not at hand. Valid until the next keep().
  [[nodiscard]] const Value* find(const Key& key) {
    for (auto entry = entries_.begin(); entry != entries_.end(); ++entry) {
      if (!(entry->first == key)) continue;
      entries_.splice(entries_.begin(), entries_, entry);
      return &entry->second;
    }
    return nullptr;
  }

  const Value& keep(Key key, Value value) { // pre: find(key) is none
    entries_.emplace_front(std::move(key), std::move(value));
    if (entries_.size() > most) entries_.pop_back();
    return entries_.front().second;
  }

private:
  std::list<std::pair<Key, Value>> entries_; // the last one asked for first
};

} // namespace espalier
