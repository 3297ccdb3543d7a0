// The content of a file as plain data: named datasets with a type, a shape and a unit.
//
// A Content is what the checksum, the comparison and the HDF5 layer have in common; none of them
// knows what the datasets mean.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <map>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include "rupture/checkpoint/kinds.hpp"

namespace rupture {

/// Element type of a dataset; stored little-endian. `text` is one fixed-length, null-padded UTF-8
/// string: its length in bytes is part of the type, and its shape is that of a scalar.
enum class DataType { float64, float32, int64, uint32, uint16, uint8, text };
inline constexpr std::array kDataTypes = {DataType::float64, DataType::float32, DataType::int64,
                                          DataType::uint32,  DataType::uint16,  DataType::uint8,
                                          DataType::text};

/// "float64", "float32", "int64", "uint32", "uint16", "uint8" or "text", as in the canonical form.
std::string_view type_name(DataType type);

/// Bytes per element; 1 for text.
std::size_t element_size(DataType type);

using Shape = std::vector<std::uint64_t>;  ///< lengths per dimension, slowest first; empty: scalar

/// Number of elements of a shape; 1 for a scalar.
std::uint64_t element_count(const Shape& shape);

/// Bytes in an array of this shape, however nonsensical; none if they are more than `most`.
std::optional<std::size_t> bytes_in(const Shape& shape, std::size_t element_size, std::size_t most);

/// "[31][57]", or "scalar".
std::string shape_text(const Shape& shape);

/// One array (or scalar, or text).
struct Dataset {
  std::string unit;  ///< SI unit, "1" for none
  DataType type = DataType::float64;
  Shape shape;
  std::vector<std::byte> bytes;  ///< the elements, row by row, without padding

  bool operator==(const Dataset&) const = default;
};

/// All datasets of a file by absolute path, e.g. "/state/u_x".
using Content = std::map<std::string, Dataset>;

/// What other programs are told about a dataset besides its unit.
struct Label {
  std::string long_name;
  /// Dataset with the values along each dimension; itself in a scale, none if unknown.
  std::vector<std::string> axes;
};
using Labels = std::map<std::string, Label>;  ///< by path

/// The element type that holds a T.
template <class T>
inline constexpr DataType kDataTypeOf = [] {
  if (std::is_same_v<T, double>) return DataType::float64;
  if (std::is_same_v<T, float>) return DataType::float32;
  if (std::is_same_v<T, std::int64_t>) return DataType::int64;
  if (std::is_same_v<T, std::uint32_t>) return DataType::uint32;
  if (std::is_same_v<T, std::uint16_t>) return DataType::uint16;
  if (std::is_same_v<T, std::uint8_t>) return DataType::uint8;
  if (std::is_same_v<T, std::string>) return DataType::text;
  throw "no type of a dataset";  // at compile time, in which this function runs
}();

/// Calls `work` with an element, zero, of a type of numbers. Throws Failure for a text.
template <class Work>
auto with_number_of(DataType type, const Work& work) {
  switch (type) {
    case DataType::float64:
      return work(double{});
    case DataType::float32:
      return work(float{});
    case DataType::int64:
      return work(std::int64_t{});
    case DataType::uint32:
      return work(std::uint32_t{});
    case DataType::uint16:
      return work(std::uint16_t{});
    case DataType::uint8:
      return work(std::uint8_t{});
    case DataType::text:
      break;
  }
  throw Failure("a text has no numbers");
}

/// A dataset that copies `values`. The number of values must be that of the shape.
template <class T>
Dataset make_array(std::span<const T> values, Shape shape, std::string_view unit) {
  const std::span<const std::byte> bytes = std::as_bytes(values);
  return {std::string(unit), kDataTypeOf<T>, std::move(shape), {bytes.begin(), bytes.end()}};
}

template <class T>
Dataset make_scalar(T value, std::string_view unit) {
  return make_array(std::span<const T>(&value, 1), {}, unit);
}

/// A text dataset. An empty text is stored as one null. Throws Failure if `text` contains a null.
Dataset make_text(std::string_view text);

/// Element `index` of a dataset of T, in storage order.
template <class T>
T element(const Dataset& dataset, std::size_t index) {
  T value{};
  std::memcpy(&value, dataset.bytes.data() + index * sizeof(T), sizeof(T));
  return value;
}

/// The dataset at `path`. Throws Failure, naming path, found and expected, if it is missing, of
/// another type or shape, or if its bytes do not fill its shape.
const Dataset& expect(const Content& content, const std::string& path, DataType type,
                      const Shape& shape);

/// The elements of the dataset at `path`. Throws Failure as expect() does.
template <class T>
std::vector<T> read_array(const Content& content, const std::string& path, const Shape& shape) {
  const Dataset& dataset = expect(content, path, kDataTypeOf<T>, shape);
  std::vector<T> values(element_count(shape));
  if (!values.empty()) std::memcpy(values.data(), dataset.bytes.data(), dataset.bytes.size());
  return values;
}

template <class T>
T read_scalar(const Content& content, const std::string& path) {
  return read_array<T>(content, path, {}).front();
}

std::string read_text(const Content& content, const std::string& path);

/// Whether they hold the same, in whatever unit.
bool is_same(const Dataset& a, const Dataset& b);

/// Throws Failure if a dataset of `content` differs, be it in its unit or in a bit that does not
/// matter, from what would be `written` in its place. Datasets that are missing are accepted, and
/// units, which other programs lose when they replace a dataset.
void expect_as_written(const Content& content, const Content& written);

/// Throws Failure, "<path> <words>", for the first dataset below `group` that is not `known`.
void refuse_others(const Content& content, std::string_view group, const Content& known,
                   std::string_view words);

/// What an alarm said that stopped a run; in the checkpoint of its state alone.
inline constexpr const char* kAlarmPath = "/alarm/sentence";

/// Throws Failure, naming dataset and index, if a float anywhere is NaN or infinite. In the
/// checkpoint of an alarm, one of the state may be.
void check_finite(const Content& content);

/// A file's kind and datasets.
struct ContentFile {
  FileKind kind = FileKind::checkpoint;
  std::string checksum;  ///< of the content; empty for an open record
  Content content;
  std::uint64_t ignored_bytes = 0;  ///< behind the last intact piece of an open record
};

/// What a file holds that another program may have changed since rupture sealed it. How it is
/// stored does not matter: it may be cut into chunks and compressed, its texts may have any form,
/// units may be missing.
struct EditedFile {
  std::string name;  ///< for messages
  FileKind kind = FileKind::checkpoint;
  std::string sealed_checksum;  ///< content checksum that rupture stored; empty if it is gone
  bool content_is_as_sealed = false;
  bool is_sealed = false;  ///< and so is every other byte
  Content content;
};

}  // namespace rupture
