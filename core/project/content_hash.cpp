#include "core/project/content_hash.h"

#include "core/base/error.h"
#include "core/base/open_for_reading.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
#include <string>
#include <vector>

namespace espalier {
namespace {

constexpr std::uint64_t prime1 = 0x9E3779B185EBCA87;
constexpr std::uint64_t prime2 = 0xC2B2AE3D27D4EB4F;
constexpr std::uint64_t prime3 = 0x165667B19E3779F9;
constexpr std::uint64_t prime4 = 0x85EBCA77C2B2AE63;
constexpr std::uint64_t prime5 = 0x27D4EB2F165667C5;
constexpr std::size_t stripe = 32; // bytes

static_assert(std::endian::native == std::endian::little, "numbers are copied as they are");

template <class Number> std::uint64_t numberAt(const char* bytes) {
  Number result = 0;
  std::memcpy(&result, bytes, sizeof(Number));
  return result;
}

std::uint64_t mixed(std::uint64_t lane, std::uint64_t input) {
  return std::rotl(lane + input * prime2, 31) * prime1;
}

/// Takes bytes in any portions.
class Hash {
public:
  void add(std::string_view bytes) {
    size_ += bytes.size();
    if (!rest_.empty()) {
      const std::size_t taken = std::min(stripe - rest_.size(), bytes.size());
      rest_.append(bytes.substr(0, taken));
      bytes.remove_prefix(taken);
      if (rest_.size() < stripe) return;
      addStripe(rest_.data());
      rest_.clear();
    }
    for (; bytes.size() >= stripe; bytes.remove_prefix(stripe))
      addStripe(bytes.data());
    rest_ = bytes;
  }

  [[nodiscard]] std::uint64_t value() const {
    std::uint64_t hash = size_ < stripe ? prime5 : converged();
    hash += size_;
    std::string_view rest = rest_;
    for (; rest.size() >= 8; rest.remove_prefix(8))
      hash = std::rotl(hash ^ mixed(0, numberAt<std::uint64_t>(rest.data())), 27) * prime1 + prime4;
    if (rest.size() >= 4) {
      hash ^= numberAt<std::uint32_t>(rest.data()) * prime1;
      hash = std::rotl(hash, 23) * prime2 + prime3;
      rest.remove_prefix(4);
    }
    for (const char c : rest)
      hash = std::rotl(hash ^ (static_cast<unsigned char>(c) * prime5), 11) * prime1;
    hash = (hash ^ (hash >> 33)) * prime2;
    hash = (hash ^ (hash >> 29)) * prime3;
    return hash ^ (hash >> 32);
  }

private:
  void addStripe(const char* bytes) {
    for (std::size_t i = 0; i < lanes_.size(); ++i)
      lanes_[i] = mixed(lanes_[i], numberAt<std::uint64_t>(bytes + 8 * i));
  }

  [[nodiscard]] std::uint64_t converged() const {
    std::uint64_t hash = std::rotl(lanes_[0], 1) + std::rotl(lanes_[1], 7) +
                         std::rotl(lanes_[2], 12) + std::rotl(lanes_[3], 18);
    for (const std::uint64_t lane : lanes_)
      hash = (hash ^ mixed(0, lane)) * prime1 + prime4;
    return hash;
  }

  std::array<std::uint64_t, 4> lanes_ = {prime1 + prime2, prime2, 0, 0 - prime1};
  std::string rest_; // shorter than a stripe
  std::uint64_t size_ = 0;
};

} // namespace

std::uint64_t contentHash(std::string_view bytes) {
  Hash hash;
  hash.add(bytes);
  return hash.value();
}

std::uint64_t contentHashOfFile(const std::filesystem::path& path) {
  std::ifstream in = openForReading(path);
  std::vector<char> buffer(std::size_t{1} << 20);
  Hash hash;
  while (in) {
    in.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
    hash.add({buffer.data(), static_cast<std::size_t>(in.gcount())});
  }
  if (!in.eof()) throw Error(path.string() + ": breaks off while it is read: try a copy of it");
  return hash.value();
}

} // namespace espalier
