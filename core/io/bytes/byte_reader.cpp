#include "core/io/bytes/byte_reader.h"

namespace espalier {

std::string_view ByteReader::takeUntil(char end) {
  const std::size_t at = bytes_.find(end, offset_);
  if (at == std::string_view::npos)
    fail(
        {espalier::Shown::tr("ends within a text: the file is cut short or damaged, copy or export "
                             "it again")});
  const std::string_view taken = take(at - offset_);
  ++offset_;
  return taken;
}

void ByteReader::failAt(std::size_t offset, ShownMessage what) const {
  what.where = FilePlace{.file = file_, .byte = offset};
  throw ShownError(std::move(what));
}

void ByteReader::failOfEnd(std::uint64_t size) const {
  fail({espalier::Shown::tr(
            "ends within a value of %1 bytes: the file is cut short or damaged, copy "
            "or export it again"),
        {std::to_string(size)}});
}

} // namespace espalier
