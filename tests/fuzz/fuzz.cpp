// Valid contents with any changes, as libhdf5 could hand them over: the code behind it refuses them
// with a Failure or accepts them, and what it accepts can be computed with and is stored again as
// it was.
#include <array>
#include <bit>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <limits>

#include "rupture/analysis/front.hpp"
#include "rupture/checkpoint/checkpoint.hpp"
#include "rupture/checkpoint/checksum.hpp"
#include "rupture/checkpoint/compare.hpp"
#include "rupture/checkpoint/record.hpp"
#include "rupture/dynamics/simulation.hpp"
#include "rupture/model/error.hpp"

using namespace rupture;

namespace {

// The bytes that a fuzzer made up, taken one after another.
class Bytes {
 public:
  explicit Bytes(std::span<const std::uint8_t> bytes) : rest_(bytes) {}

  bool empty() const { return rest_.empty(); }

  // The next number; zeros stand in for what is missing at the end.
  template <class T>
  T take() {
    T value{};
    const auto bytes = next(sizeof(T));
    if (!bytes.empty()) std::memcpy(&value, bytes.data(), bytes.size());
    return value;
  }

  // One of `choices`, which must not be empty.
  template <class Choices>
  const auto& pick(const Choices& choices) {
    return *std::next(std::begin(choices),
                      static_cast<std::ptrdiff_t>(take<std::uint8_t>() % std::size(choices)));
  }

  // A text of up to 255 bytes, its length first.
  std::string text() {
    const auto bytes = next(take<std::uint8_t>());
    return {bytes.begin(), bytes.end()};
  }

 private:
  // Fewer if they end before.
  std::span<const std::uint8_t> next(std::size_t size) {
    const auto bytes = rest_.first(std::min(size, rest_.size()));
    rest_ = rest_.subspan(bytes.size());
    return bytes;
  }

  std::span<const std::uint8_t> rest_;
};

constexpr std::size_t kLargest = 1U << 20U;  // [bytes] of a dataset

enum class Edit { erase, copy, retype, reshape, fill, set_element, set_text, set_unit };
constexpr std::array kEdits = {Edit::erase, Edit::copy,        Edit::retype,   Edit::reshape,
                               Edit::fill,  Edit::set_element, Edit::set_text, Edit::set_unit};
constexpr std::array kTypes = {DataType::float64, DataType::int64, DataType::uint32,
                               DataType::uint16,  DataType::uint8, DataType::text};
constexpr std::array<std::uint64_t, 12> kLengths = {0, 1,  2,  3,     4,         5,
                                                    6, 12, 64, 65536, 1U << 31U, ~0ULL};
using Double = std::numeric_limits<double>;
constexpr double kMax = Double::max(), kInf = Double::infinity(), kNan = Double::quiet_NaN();
constexpr std::array kDoubles = {
    0.0, -0.0, 1.0, -1.0, 1e-9, 0.5, 1e3, 1e300, kMax, Double::denorm_min(), kInf, kNan};
constexpr std::int64_t kLeast = std::numeric_limits<std::int64_t>::min();
constexpr std::array<std::int64_t, 12> kIntegers = {
    0, 1, 2, 3, 4, -1, 65535, 65536, 1LL << 31, 1LL << 53, (1LL << 53) + 1, kLeast};

// As many bytes as type and shape need, as the reader guarantees; false if that is too many.
bool fit(Dataset& dataset) {
  if (dataset.type == DataType::text) dataset.shape.clear();
  std::size_t bytes = element_size(dataset.type);
  if (dataset.type == DataType::text) bytes = std::max<std::size_t>(dataset.bytes.size(), 1);
  const auto needed = bytes_in(dataset.shape, bytes, kLargest);
  if (needed) dataset.bytes.resize(*needed);
  return needed.has_value();
}

// Eight bytes: those of a number that is good at breaking things, or any.
std::uint64_t number(Bytes& input) {
  switch (input.take<std::uint8_t>() % 3) {
    case 0:
      return std::bit_cast<std::uint64_t>(input.pick(kDoubles));
    case 1:
      return static_cast<std::uint64_t>(input.pick(kIntegers));
    default:
      return input.take<std::uint64_t>();
  }
}

void set_element(Dataset& dataset, std::size_t index, std::uint64_t value) {
  const std::size_t size = element_size(dataset.type);
  const std::size_t count = dataset.bytes.size() / size;
  if (count > 0) std::memcpy(dataset.bytes.data() + index % count * size, &value, size);
}

void edit(Content& content, Edit edit, Bytes& input) {
  if (content.empty()) return;
  auto& [path, dataset] =
      *std::next(content.begin(), input.take<std::uint8_t>() % static_cast<int>(content.size()));
  Dataset changed = dataset;
  switch (edit) {
    case Edit::erase:
      content.erase(std::string(path));
      return;
    case Edit::copy:
      content[std::string(1, '/').append(input.text())] = dataset;
      return;
    case Edit::retype:
      changed.type = input.pick(kTypes);
      break;
    case Edit::reshape:
      changed.shape.assign(input.take<std::uint8_t>() % 4, 0);
      for (std::uint64_t& length : changed.shape) length = input.pick(kLengths);
      break;
    case Edit::fill: {
      const std::uint64_t value = number(input);
      for (std::size_t i = 0; i < changed.bytes.size() / element_size(changed.type); ++i)
        set_element(changed, i, value);
      break;
    }
    case Edit::set_element: {
      const auto index = input.take<std::uint8_t>();
      set_element(changed, index, number(input));
      break;
    }
    case Edit::set_text: {
      const std::string text = input.text();
      const auto bytes = std::as_bytes(std::span(text));
      changed = {changed.unit, DataType::text, {}, {bytes.begin(), bytes.end()}};
      break;
    }
    case Edit::set_unit:
      changed.unit = input.text();
      break;
  }
  if (fit(changed)) dataset = std::move(changed);
}

Content content_of(const char* name) {
  const auto folder = std::filesystem::path(__FILE__).parent_path() / "../compatibility/schema-3";
  return read_file(folder / name).content;
}

Content checkpoint_of(const char* name) {
  Checkpoint checkpoint = checkpoint_from(content_of(name));
  checkpoint.run.reset();
  return checkpoint_content(checkpoint);
}

// What all records hold, and crossings.
Content record_of(const char* name) {
  Content content = content_of(name);
  content.merge(parameters_content(read_parameters(content)));
  std::erase_if(content, [](const auto& item) {
    const std::string_view path = item.first;
    return path.starts_with("/run/") || path.starts_with("/fields/") || path.ends_with("/x");
  });
  return content;
}

void demand(bool holds) {
  if (!holds) std::abort();
}

void use_checkpoint(const Content& content) {
  const Checkpoint checkpoint = checkpoint_from(content);
  const Content again = checkpoint_content(checkpoint);
  for (const auto& [path, dataset] : content) {
    if (!is_checksummed(path)) continue;
    Dataset written = again.at(path);
    if (dataset.unit.empty()) written.unit.clear();  // a lost unit is written again
    demand(written == dataset);
  }
  Simulation simulation(checkpoint.parameters, checkpoint.state);
  simulation.advance(2);
}

void use_record(const Content& content) {
  const Record record = record_from({FileKind::record, "", content});
  demand(record.p.rows() == static_cast<Eigen::Index>(record.time.size()));
  find_events(record.parameters, record.ruptures, {record.time, record.F_T}, 1e-3, {});
}

void use(const Content& content, const Content& original, bool is_record) {
  diff(content, original);
  content_checksum(content);
  try {
    check_finite(content);
    if (is_record) {
      use_record(content);
    } else {
      use_checkpoint(content);
    }
  } catch (const Failure&) {
  } catch (const UsageError&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::array originals = {checkpoint_of("reference.h5"),
                                       checkpoint_of("simplified.h5"), checkpoint_of("decaying.h5"),
                                       record_of("parts-record.h5")};
  Bytes input({data, size});
  const std::size_t chosen = input.take<std::uint8_t>() % originals.size();
  Content content = originals[chosen];
  while (!input.empty()) edit(content, input.pick(kEdits), input);
  use(content, originals[chosen], chosen + 1 == originals.size());
  return 0;
}
