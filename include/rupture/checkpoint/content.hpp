// The content of a file as plain data: named datasets with a type, a shape and a unit.
//
// A Content is what the checksum, the comparison and the HDF5 layer have in common; none of them
// knows what the datasets mean.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rupture {

/// Element type of a dataset; stored little-endian. `text` is one fixed-length, null-padded UTF-8
/// string: its length in bytes is part of the type, and its shape is that of a scalar.
enum class DataType { float64, float32, int64, uint32, uint16, uint8, text };

/// "float64", "float32", "int64", "uint32", "uint16", "uint8" or "text", as in the canonical form.
std::string_view type_name(DataType type);

/// Bytes per element; 1 for text.
std::size_t element_size(DataType type);

using Shape = std::vector<std::uint64_t>;  ///< lengths per dimension, slowest first; empty: scalar

/// Number of elements of a shape; 1 for a scalar.
std::uint64_t element_count(const Shape& shape);

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

template <class T>
struct DataTypeOf;
template <>
struct DataTypeOf<double> {
  static constexpr DataType value = DataType::float64;
};
template <>
struct DataTypeOf<float> {
  static constexpr DataType value = DataType::float32;
};
template <>
struct DataTypeOf<std::int64_t> {
  static constexpr DataType value = DataType::int64;
};
template <>
struct DataTypeOf<std::uint32_t> {
  static constexpr DataType value = DataType::uint32;
};
template <>
struct DataTypeOf<std::uint16_t> {
  static constexpr DataType value = DataType::uint16;
};
template <>
struct DataTypeOf<std::uint8_t> {
  static constexpr DataType value = DataType::uint8;
};

/// A dataset that copies `values`. The number of values must be that of the shape.
template <class T>
Dataset make_array(std::span<const T> values, Shape shape, std::string_view unit) {
  const std::span<const std::byte> bytes = std::as_bytes(values);
  return {std::string(unit), DataTypeOf<T>::value, std::move(shape), {bytes.begin(), bytes.end()}};
}

template <class T>
Dataset make_scalar(T value, std::string_view unit) {
  return make_array(std::span<const T>(&value, 1), {}, unit);
}

/// A text dataset. An empty text is stored as one null. Throws Failure if `text` contains a null.
Dataset make_text(std::string_view text);

/// The dataset at `path`. Throws Failure, naming path, found and expected, if it is missing, of
/// another type or shape, or if its bytes do not fill its shape.
const Dataset& expect(const Content& content, const std::string& path, DataType type,
                      const Shape& shape);

/// Copies the dataset at `path` to `out`. Throws Failure as expect() does.
void read_array_bytes(const Content& content, const std::string& path, DataType type,
                      const Shape& shape, std::span<std::byte> out);

template <class T>
std::vector<T> read_array(const Content& content, const std::string& path, const Shape& shape) {
  expect(content, path, DataTypeOf<T>::value, shape);
  std::vector<T> values(element_count(shape));
  read_array_bytes(content, path, DataTypeOf<T>::value, shape,
                   std::as_writable_bytes(std::span(values)));
  return values;
}

template <class T>
T read_scalar(const Content& content, const std::string& path) {
  T value{};
  read_array_bytes(content, path, DataTypeOf<T>::value, {},
                   std::as_writable_bytes(std::span(&value, 1)));
  return value;
}

std::string read_text(const Content& content, const std::string& path);

/// Throws Failure if a dataset of `content` differs, be it in its unit or in a bit that does not
/// matter, from what would be `written` in its place. Datasets that are missing are accepted.
void expect_as_written(const Content& content, const Content& written);

/// Throws Failure, naming dataset and index, if a float anywhere is NaN or infinite.
void check_finite(const Content& content);

/// The same for one dataset.
void check_finite(const std::string& path, const Dataset& dataset);

}  // namespace rupture
