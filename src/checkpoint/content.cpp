#include "rupture/checkpoint/content.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstring>

#include "rupture/model/error.hpp"

namespace rupture {
namespace {

static_assert(std::endian::native == std::endian::little,
              "datasets are kept in memory as they are stored: little-endian");

std::string describe(DataType type, const Shape& shape) {
  if (type == DataType::text) return "text";
  if (shape.empty()) return fmt::format("one {}", type_name(type));
  return fmt::format("{} of shape {}", type_name(type), shape_text(shape));
}

// Whether there are as many bytes as type and shape need, without overflow.
bool fills_its_shape(const Dataset& dataset) {
  if (dataset.type == DataType::text) return !dataset.bytes.empty();
  std::size_t bytes = element_size(dataset.type);
  for (const std::uint64_t length : dataset.shape) {
    if (length != 0 && bytes > dataset.bytes.size() / length) return false;
    bytes *= length;
  }
  return bytes == dataset.bytes.size();
}

template <class T>
void check_all_finite(const std::string& path, const Dataset& dataset) {
  const std::size_t count = dataset.bytes.size() / sizeof(T);
  const auto value = [&](std::size_t i) {
    T x = 0;
    std::memcpy(&x, dataset.bytes.data() + i * sizeof(T), sizeof(T));
    return x;
  };
  unsigned others = 0;  // counted without branches, which is faster for large arrays
  for (std::size_t i = 0; i < count; ++i) others += std::isfinite(value(i)) ? 0U : 1U;
  if (others == 0) return;
  std::size_t i = 0;
  while (std::isfinite(value(i))) ++i;
  throw Failure(fmt::format("{} holds {} at index {} of {}; only finite numbers are stored", path,
                            value(i), i, shape_text(dataset.shape)));
}

}  // namespace

std::string_view type_name(DataType type) {
  switch (type) {
    case DataType::float64:
      return "float64";
    case DataType::float32:
      return "float32";
    case DataType::int64:
      return "int64";
    case DataType::uint32:
      return "uint32";
    case DataType::uint16:
      return "uint16";
    case DataType::uint8:
      return "uint8";
    case DataType::text:
      return "text";
  }
  throw Failure("a dataset has an element type unknown to this build");
}

std::size_t element_size(DataType type) {
  switch (type) {
    case DataType::float64:
    case DataType::int64:
      return 8;
    case DataType::float32:
    case DataType::uint32:
      return 4;
    case DataType::uint16:
      return 2;
    case DataType::uint8:
    case DataType::text:
      return 1;
  }
  throw Failure("a dataset has an element type unknown to this build");
}

std::uint64_t element_count(const Shape& shape) {
  std::uint64_t count = 1;
  for (const std::uint64_t length : shape) count *= length;
  return count;
}

std::string shape_text(const Shape& shape) {
  if (shape.empty()) return "scalar";
  std::string text;
  for (const std::uint64_t length : shape) text += fmt::format("[{}]", length);
  return text;
}

Dataset make_text(std::string_view text) {
  if (text.find('\0') != std::string_view::npos) {
    throw Failure("a text to be stored contains a null byte; texts are null-padded");
  }
  const std::span<const std::byte> bytes = std::as_bytes(std::span(text));
  Dataset dataset{"1", DataType::text, {}, {bytes.begin(), bytes.end()}};
  if (text.empty()) dataset.bytes.push_back(std::byte{0});  // HDF5 has no strings of length 0
  return dataset;
}

const Dataset& expect(const Content& content, const std::string& path, DataType type,
                      const Shape& shape) {
  const auto found = content.find(path);
  if (found == content.end()) {
    throw Failure(fmt::format("{} is missing; expected {}", path, describe(type, shape)));
  }
  const Dataset& dataset = found->second;
  if (dataset.type != type || dataset.shape != shape) {
    throw Failure(fmt::format("{} holds {}; expected {}", path,
                              describe(dataset.type, dataset.shape), describe(type, shape)));
  }
  if (!fills_its_shape(dataset)) {
    throw Failure(fmt::format("{} holds {} bytes, which is not {}", path, dataset.bytes.size(),
                              describe(type, shape)));
  }
  return dataset;
}

void expect_as_written(const Content& content, const Content& written) {
  for (const auto& [path, dataset] : written) {
    const auto found = content.find(path);
    if (found == content.end() || found->second == dataset) continue;
    if (found->second.unit != dataset.unit) {
      throw Failure(
          fmt::format("{} is in {}; expected {}", path, found->second.unit, dataset.unit));
    }
    throw Failure(fmt::format("{} holds its value in a form that rupture never writes", path));
  }
}

void read_array_bytes(const Content& content, const std::string& path, DataType type,
                      const Shape& shape, std::span<std::byte> out) {
  const Dataset& dataset = expect(content, path, type, shape);
  if (dataset.bytes.size() != out.size()) {
    throw Failure(
        fmt::format("{} holds {} bytes; expected {}", path, dataset.bytes.size(), out.size()));
  }
  if (!out.empty()) std::memcpy(out.data(), dataset.bytes.data(), out.size());
}

std::string read_text(const Content& content, const std::string& path) {
  const Shape scalar;
  const Dataset& dataset = expect(content, path, DataType::text, scalar);
  std::string text(reinterpret_cast<const char*>(dataset.bytes.data()), dataset.bytes.size());
  text.resize(text.find_last_not_of('\0') + 1);  // npos + 1 = 0: nothing but nulls
  return text;
}

void check_finite(const std::string& path, const Dataset& dataset) {
  if (dataset.type == DataType::float64) check_all_finite<double>(path, dataset);
  if (dataset.type == DataType::float32) check_all_finite<float>(path, dataset);
}

void check_finite(const Content& content) {
  for (const auto& [path, dataset] : content) check_finite(path, dataset);
}

}  // namespace rupture
