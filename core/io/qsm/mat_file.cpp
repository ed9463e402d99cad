#include "core/io/qsm/mat_file.h"

#include "core/base/shown_message.h"
#include "core/io/bytes/byte_reader.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <zlib.h>

namespace espalier {
namespace {

constexpr std::size_t headerSize = 128;
constexpr std::size_t mostUnpacked = std::size_t{1} << 27;
constexpr std::size_t mostUnpackedOfAll = std::size_t{1} << 30;
constexpr std::size_t mostNumbers = std::size_t{1} << 22; // of an array: over a million cylinders
constexpr std::uint32_t matrixType = 14;
constexpr std::uint32_t compressedType = 15;
constexpr std::uint8_t structureClass = 2;
constexpr std::uint8_t firstNumberClass = 6;
constexpr std::uint8_t lastNumberClass = 15;
constexpr std::uint8_t complexFlag = 0x08;

/// A piece of a file: what kind of values, and their bytes.
struct Element {
  std::uint32_t type = 0;
  std::string_view data;
};

Element takeElement(ByteReader& in, std::endian order) {
  const auto word = in.value<std::uint32_t>(order);
  if (word >> 16 != 0) { // up to 4 bytes of data lie in the tag itself
    const std::uint32_t size = word >> 16;
    const std::string_view data = in.take(4);
    if (size > data.size())
      in.fail({espalier::Shown::tr("has a short element of more than 4 bytes: it is damaged")});
    return {word & 0xffff, data.substr(0, size)};
  }
  const auto size = in.value<std::uint32_t>(order);
  const Element element{word, in.take(size)};
  if (word != compressedType) (void)in.take(std::min<std::size_t>(in.left(), (8 - size % 8) % 8));
  return element;
}

std::optional<ScalarType> scalarTypeOf(std::uint32_t type) {
  switch (type) {
  case 1:
    return ScalarType::int8;
  case 2:
    return ScalarType::uint8;
  case 3:
    return ScalarType::int16;
  case 4:
    return ScalarType::uint16;
  case 5:
    return ScalarType::int32;
  case 6:
    return ScalarType::uint32;
  case 7:
    return ScalarType::float32;
  case 9:
    return ScalarType::float64;
  case 12:
    return ScalarType::int64;
  case 13:
    return ScalarType::uint64;
  default:
    return std::nullopt;
  }
}

/// A stream of zlib, taken apart piece by piece.
class Inflater {
public:
  explicit Inflater(std::string_view packed) {
    // zlib does not write to its input.
    stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
    stream_.avail_in = static_cast<uInt>(packed.size()); // 32 bits in the file
    isReady_ = inflateInit(&stream_) == Z_OK;
  }
  ~Inflater() {
    if (isReady_) inflateEnd(&stream_);
  }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  /// All of it; none if it is damaged, cut short or longer than `most`, which `isTooLong` says.
  std::optional<std::string> all(std::size_t most) {
    std::string bytes;
    isTooLong = false;
    std::vector<char> block(std::size_t{1} << 16);
    int status = isReady_ ? Z_OK : Z_MEM_ERROR;
    while (status == Z_OK) {
      stream_.next_out = reinterpret_cast<Bytef*>(block.data());
      stream_.avail_out = static_cast<uInt>(block.size());
      status = inflate(&stream_, Z_NO_FLUSH);
      bytes.append(block.data(), block.size() - stream_.avail_out);
      isTooLong = bytes.size() > most;
      if (isTooLong) return std::nullopt;
    }
    return status == Z_STREAM_END ? std::optional(std::move(bytes)) : std::nullopt;
  }

  bool isTooLong = false;

private:
  z_stream stream_{};
  bool isReady_ = false;
};

/// Names of the fields of a structure, and the matrices of its first element.
std::vector<std::pair<std::string, std::string_view>> takeFields(ByteReader& in, std::endian order,
                                                                 bool isEmpty) {
  const Element size = takeElement(in, order);
  if (size.data.size() != 4)
    in.fail({espalier::Shown::tr("gives no size of the names of its fields: it is damaged")});
  const auto nameSize = valueAt<std::uint32_t>(size.data.data(), order);
  const std::string_view names = takeElement(in, order).data;
  if (nameSize == 0 || names.size() % nameSize != 0)
    in.fail({espalier::Shown::tr("has names of fields that are cut short: it is damaged")});
  std::vector<std::pair<std::string, std::string_view>> fields;
  for (std::size_t at = 0; !isEmpty && at < names.size(); at += nameSize) {
    const std::string_view name = names.substr(at, nameSize);
    const Element element = takeElement(in, order);
    if (element.type != matrixType)
      in.fail({espalier::Shown::tr("has a field that is no matrix: it is damaged")});
    fields.emplace_back(name.substr(0, name.find('\0')), element.data);
  }
  return fields;
}

std::vector<double> takeValues(ByteReader& in, std::endian order, const MatArray& array) {
  if (array.rows == 0 || array.columns == 0) return {};
  const Element element = takeElement(in, order);
  const auto type = scalarTypeOf(element.type);
  if (!type)
    in.fail({espalier::Shown::tr("has numbers of a type that is not known: it is damaged")});
  const std::size_t size = sizeOf(*type);
  const std::uint64_t count = element.data.size() / size;
  if (element.data.size() % size != 0 || array.columns > count / array.rows ||
      array.rows * array.columns != count)
    in.fail({count == 1 ? espalier::Shown::tr("has 1 number, expected %2 x %3: it is damaged")
                        : espalier::Shown::tr("has %1 numbers, expected %2 x %3: it is damaged"),
             {std::to_string(count), std::to_string(array.rows), std::to_string(array.columns)}});
  if (count > mostNumbers)
    in.fail({espalier::Shown::tr(
                 "has %1 numbers in one array, more than any model: at most %2 are read"),
             {std::to_string(count), std::to_string(mostNumbers)}});
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i)
    values[i] = scalarAt(element.data.data() + i * size, *type, order);
  return values;
}

void takeSize(ByteReader& in, std::endian order, MatArray& array) {
  const std::string_view sizes = takeElement(in, order).data;
  if (sizes.size() < 8 || sizes.size() % 4 != 0)
    in.fail({espalier::Shown::tr("has a variable without a size: it is damaged")});
  array.rows = valueAt<std::uint32_t>(sizes.data(), order);
  array.columns = 1;
  for (std::size_t at = 4; at < sizes.size(); at += 4) {
    const std::uint64_t size = valueAt<std::uint32_t>(sizes.data() + at, order);
    if (size > 0 && array.columns > std::numeric_limits<std::uint32_t>::max() / size)
      in.fail(
          {espalier::Shown::tr("has a variable of too many elements to be true: it is damaged")});
    array.columns *= size;
  }
}

MatArray takeArray(ByteReader& in, std::endian order) {
  MatArray array;
  const std::string_view flags = takeElement(in, order).data;
  if (flags.size() != 8)
    in.fail({espalier::Shown::tr("has a variable without flags: it is damaged")});
  const auto word = valueAt<std::uint32_t>(flags.data(), order);
  const auto classType = static_cast<std::uint8_t>(word & 0xff);
  const bool isComplex = (word >> 8 & complexFlag) != 0;
  takeSize(in, order, array);
  array.name = takeElement(in, order).data;
  if (classType == structureClass) {
    array.kind = MatArray::Kind::structure;
    array.fields = takeFields(in, order, array.rows == 0 || array.columns == 0);
  } else if (classType >= firstNumberClass && classType <= lastNumberClass && !isComplex) {
    array.kind = MatArray::Kind::numbers;
    array.values = takeValues(in, order, array);
  }
  return array;
}

/// What `take` returns. Its errors name no byte: those of an unpacked variable are not the file's.
template <class Take> auto withoutBytes(const Take& take) {
  try {
    return take();
  } catch (const ShownError& error) {
    ShownMessage message = error.message();
    if (message.where) message.where->byte.reset();
    throw ShownError(std::move(message));
  }
}

} // namespace

MatFile::MatFile(std::string_view bytes, std::string file) : bytes_(bytes), file_(std::move(file)) {
  if (bytes.size() < headerSize)
    throw ShownError(
        {espalier::Shown::tr("ends within its header: the file is cut short, copy it again"),
         {},
         FilePlace{file_}});
  if (bytes.starts_with("MATLAB 7.3"))
    throw ShownError({espalier::Shown::tr("is a MAT file of version 7.3, and 5 to 7 can be read: "
                                          "save it by save(name, '-v7', ...)"),
                      {},
                      FilePlace{file_}});
  const std::string_view mark = bytes.substr(headerSize - 2, 2);
  if (!bytes.starts_with("MATLAB ") || (mark != "IM" && mark != "MI"))
    throw ShownError(
        {espalier::Shown::tr(
             "is no MAT file of MATLAB 5 to 7: save it again by save(name, '-v7', ...)"),
         {},
         FilePlace{file_}});
  if (mark == "MI") order_ = std::endian::big;
  offset_ = headerSize;
}

bool MatFile::next(std::string& unpacked) {
  while (offset_ < bytes_.size()) {
    ByteReader in(bytes_, file_);
    (void)in.take(offset_);
    Element element = takeElement(in, order_);
    offset_ = in.offset();
    if (element.type == compressedType) {
      Inflater inflater(element.data);
      const auto data = inflater.all(mostUnpacked);
      if (!data)
        in.fail({inflater.isTooLong
                     ? espalier::Shown::tr("has a variable that unpacks to over 128 MiB, as of no "
                                           "model: save the model alone")
                     : espalier::Shown::tr("has a variable that cannot be unpacked: the file is "
                                           "damaged, save it again")});
      unpacked_ += data->size();
      if (unpacked_ > mostUnpackedOfAll)
        in.fail({espalier::Shown::tr(
            "unpacks to over 1 GiB up to here, as of no model: save the model alone")});
      element = withoutBytes([&] {
        ByteReader inner(*data, file_);
        return takeElement(inner, order_);
      });
      if (element.type == matrixType) {
        unpacked = element.data;
        return true;
      }
    } else if (element.type == matrixType) {
      unpacked = element.data;
      return true;
    }
  }
  return false;
}

MatArray MatFile::array(std::string_view matrix) const {
  if (matrix.empty()) return {}; // how an empty field may lie
  return withoutBytes([&] {
    ByteReader in(matrix, file_);
    return takeArray(in, order_);
  });
}

} // namespace espalier
