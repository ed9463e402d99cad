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
  /// @param pages  must outlive the packets
  explicit E57Packets(E57Pages& pages) : pages_(pages), left_(pages.size()) {}

  /// Begins with a scan, which must be there until the next begins.
  /// @return a stream for each field, still empty; those without a role stay so
  /// @throws Error naming the byte where its section is damaged
  [[nodiscard]] std::vector<E57Stream> begin(const E57Scan& scan);

  /// Adds packets to the streams until a record can be read of all of them. Packets of an index and
  /// empty ones are passed over.
  /// @return how many records can be read
  /// @throws Error naming the byte of the packet that is damaged, or if values are missing
  [[nodiscard]] std::uint64_t readOn(std::vector<E57Stream>& streams, const Progress& progress);

private:
  void enterSection();
  void addPacket(std::string_view packet, std::vector<E57Stream>& streams) const;
  [[nodiscard]] std::uint64_t readyIn(const std::vector<E57Stream>& streams) const;
  [[noreturn]] void failAtEnd(const std::vector<E57Stream>& streams) const;

  E57Pages& pages_;
  std::uint64_t left_; // bytes of sections that may still be read
  const E57Scan* scan_ = nullptr;
  std::uint64_t place_ = 0; // of the next packet of its section, in the content
  std::uint64_t end_ = 0;   // of this section
};

} // namespace espalier
