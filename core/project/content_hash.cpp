#include "core/project/content_hash.h"

#include "core/base/open_for_reading.h"
#include "core/base/shown_message.h"

#include <cstddef>
#include <memory>
#include <vector>
#include <xxhash.h>

namespace espalier {
namespace {

constexpr std::uint64_t seed = 0;

} // namespace

std::uint64_t contentHash(std::string_view bytes) {
  return XXH64(bytes.data(), bytes.size(), seed);
}

std::uint64_t contentHashOfFile(const std::filesystem::path& path, const Progress& progress) {
  std::ifstream in = openForReading(path);
  std::vector<char> buffer(std::size_t{1} << 20);
  const std::unique_ptr<XXH64_state_t, decltype(&XXH64_freeState)> state(XXH64_createState(),
                                                                         &XXH64_freeState);
  XXH64_reset(state.get(), seed);
  while (in) {
    progress.check();
    in.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
    XXH64_update(state.get(), buffer.data(), static_cast<std::size_t>(in.gcount()));
  }
  if (!in.eof())
    throw ShownError({espalier::Shown::tr("breaks off while it is read: try a copy of it"),
                      {},
                      FilePlace{path.string()}});
  return XXH64_digest(state.get());
}

} // namespace espalier
