#pragma once

#include "core/base/progress.h"
#include "core/io/points/e57_pages.h"
#include "core/io/points/e57_scans.h"

#include <cstdint>
#include <vector>

namespace espalier {

/// Finds the streams of scans in the packets of their sections.
///
/// Of hostile files: no section is read for two scans, so that all scans together take no longer
/// than their file is long.
class E57Packets {
public:
  explicit E57Packets(const E57Pages& pages) : pages_(pages), left_(pages.size()) {}

  /// A stream for each field of the scan; those without a role stay empty, all others have a value
  /// for each record. Packets of an index and empty ones are passed over.
  /// @throws Error naming the byte of the packet that is damaged, or if values are missing
  [[nodiscard]] std::vector<E57Stream> streamsOf(const E57Scan& scan, const Progress& progress);

private:
  struct Section {
    std::size_t packets = 0; // where they begin
    std::size_t end = 0;
  };
  [[nodiscard]] Section sectionOf(const E57Scan& scan);
  void addPacket(std::string_view packet, std::size_t place, const E57Scan& scan,
                 std::vector<E57Stream>& streams) const;
  void requireAll(const E57Scan& scan, const std::vector<E57Stream>& streams,
                  std::size_t end) const;

  const E57Pages& pages_;
  std::uint64_t left_; // bytes of sections that may still be read
};

} // namespace espalier
