#include "rupture/checkpoint/content.hpp"

#include <bit>
#include <cmath>

#include "checkpoint/content/context.hpp"

namespace rupture {
namespace {

static_assert(std::endian::native == std::endian::little,
              "datasets are kept in memory as they are stored: little-endian");

struct TypeRow {
  std::string_view name;
  std::size_t size;  // of an element [bytes]
};
constexpr std::array<TypeRow, kDataTypes.size()> kTypes = {{{"float64", 8},
                                                            {"float32", 4},
                                                            {"int64", 8},
                                                            {"uint32", 4},
                                                            {"uint16", 2},
                                                            {"uint8", 1},
                                                            {"text", 1}}};

const TypeRow& row_of(DataType type) {
  return kTypes.at(static_cast<std::size_t>(type));
}

std::string describe(DataType type, const Shape& shape) {
  if (type == DataType::text) return "text";
  if (shape.empty()) return fmt::format("one {}", type_name(type));
  return fmt::format("{} of shape {}", type_name(type), shape_text(shape));
}

// Whether there are as many bytes as type and shape need.
bool fills_its_shape(const Dataset& dataset) {
  const std::size_t bytes = dataset.bytes.size();
  if (dataset.type == DataType::text) return bytes > 0;
  return bytes_in(dataset.shape, element_size(dataset.type), bytes) == bytes;
}

template <class T>
void check_all_finite(const std::string& path, const Dataset& dataset) {
  const std::size_t count = dataset.bytes.size() / sizeof(T);
  const auto is_other = [&](std::size_t i) { return !std::isfinite(element<T>(dataset, i)); };
  unsigned others = 0;  // counted without branches, which is faster for large arrays
  for (std::size_t i = 0; i < count; ++i) others += is_other(i) ? 1U : 0U;
  if (others == 0) return;
  std::size_t i = 0;
  while (!is_other(i)) ++i;
  fail("{} holds {} at index {} of {}; only finite numbers are stored", path,
       element<T>(dataset, i), i, shape_text(dataset.shape));
}

}  // namespace

std::string_view type_name(DataType type) {
  return row_of(type).name;
}

std::size_t element_size(DataType type) {
  return row_of(type).size;
}

std::uint64_t element_count(const Shape& shape) {
  std::uint64_t count = 1;
  for (const std::uint64_t length : shape) count *= length;
  return count;
}

std::optional<std::size_t> bytes_in(const Shape& shape, std::size_t element_size,
                                    std::size_t most) {
  std::size_t bytes = element_size;
  for (const std::uint64_t length : shape) {
    if (length != 0 && bytes > most / length) return std::nullopt;
    bytes *= length;
  }
  return bytes <= most ? std::optional(bytes) : std::nullopt;
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
    throw Failure("{} is missing; expected {}", path, describe(type, shape));
  }
  const Dataset& dataset = found->second;
  if (dataset.type != type || dataset.shape != shape) {
    fail("{} holds {}; expected {}", path, describe(dataset.type, dataset.shape),
         describe(type, shape));
  }
  if (!fills_its_shape(dataset)) {
    fail("{} holds {} bytes, which is not {}", path, dataset.bytes.size(), describe(type, shape));
  }
  return dataset;
}

bool is_same(const Dataset& a, const Dataset& b) {
  return a.type == b.type && a.shape == b.shape && a.bytes == b.bytes;
}

void expect_as_written(const Content& content, const Content& written) {
  for (const auto& [path, dataset] : written) {
    const auto found = content.find(path);
    if (found == content.end()) continue;
    if (const std::string& unit = found->second.unit; !unit.empty() && unit != dataset.unit) {
      fail("{} is in {}; expected {}", path, unit, dataset.unit);
    }
    if (is_same(found->second, dataset)) continue;
    fail("{} stores its value in a form that rupture never writes", path);
  }
}

void refuse_others(const Content& content, std::string_view group, const Content& known,
                   std::string_view words) {
  for (const auto& [path, dataset] : content) {
    if (path.starts_with(group) && !known.contains(path)) fail("{} {}", path, words);
  }
}

std::string read_text(const Content& content, const std::string& path) {
  const Shape scalar;
  const Dataset& dataset = expect(content, path, DataType::text, scalar);
  std::string text(reinterpret_cast<const char*>(dataset.bytes.data()), dataset.bytes.size());
  text.resize(text.find_last_not_of('\0') + 1);  // npos + 1 = 0: nothing but nulls
  return text;
}

void check_finite(const Content& content) {
  const bool is_of_alarm = content.contains(kAlarmPath);
  for (const auto& [path, dataset] : content) {
    if (is_of_alarm && path.starts_with("/state/")) continue;
    if (dataset.type == DataType::float64) check_all_finite<double>(path, dataset);
    if (dataset.type == DataType::float32) check_all_finite<float>(path, dataset);
  }
}

}  // namespace rupture
