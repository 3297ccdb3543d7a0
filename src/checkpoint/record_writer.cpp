#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "atomic_write.hpp"
#include "part_file.hpp"
#include "record_layout.hpp"
#include "rupture/checkpoint/checkpoint.hpp"
#include "rupture/checkpoint/record.hpp"
#include "rupture/model/derived.hpp"
#include "rupture/model/error.hpp"

namespace rupture {
namespace {

namespace layout = record_layout;

template <class T>
void append_values(std::vector<T>& buffer, const std::vector<T>& values) {
  buffer.insert(buffer.end(), values.begin(), values.end());
}

void check_size(const char* what, std::size_t size, std::size_t Nx) {
  if (size != Nx) {
    throw Failure(fmt::format("a sample has {} values of {}; expected Nx = {}", size, what, Nx));
  }
}

void check_count_range(const Parameters& parameters) {
  constexpr std::int64_t most = std::numeric_limits<std::uint16_t>::max();
  if (springs_per_block(parameters) > most) {
    throw UsageError(
        fmt::format("junctions.N_s = {} is too large for a record, which counts up to "
                    "{} junctions per block",
                    parameters.N_s, most));
  }
}

// Everything a record holds: its rows so far and what stays as it is.
Content first_piece(const Parameters& parameters, const std::vector<ProvenanceEntry>& provenance,
                    Content rows) {
  rows.merge(parameters_content(parameters));
  rows.merge(provenance_content(provenance));
  return rows;
}

}  // namespace

// The samples since the last flush, one array per dataset.
class RecordWriter::Buffers {
 public:
  Buffers(std::size_t Nx, std::size_t flush_every) : Nx_(Nx), flush_every_(flush_every) {}

  void add(const Sample& sample) {
    check_size("pinned", sample.pinned.size(), Nx_);
    check_size("p", sample.p.size(), Nx_);
    check_size("tau", sample.tau.size(), Nx_);
    check_size("u_x", sample.u_x.size(), Nx_);
    time_.push_back(sample.time);
    step_.push_back(sample.step);
    F_T_.push_back(sample.F_T);
    x_drive_.push_back(sample.x_drive);
    append_values(pinned_, sample.pinned);
    append_values(p_, sample.p);
    append_values(tau_, sample.tau);
    append_values(u_x_, sample.u_x);
  }

  void add(const Rupture& rupture) {
    rupture_step_.push_back(rupture.step);
    rupture_time_.push_back(rupture.time);
    rupture_block_.push_back(rupture.block);
  }

  bool empty() const { return time_.empty() && rupture_time_.empty(); }
  bool full() const { return std::max(time_.size(), rupture_time_.size()) >= flush_every_; }

  Content content() const {
    Content content;
    content[layout::kTime] = per_row(time_, "s");
    content[layout::kStep] = per_row(step_, "1");
    content[layout::kDrivingForce] = per_row(F_T_, "N");
    content[layout::kDrivePosition] = per_row(x_drive_, "m");
    content[layout::kPinned] = per_block(pinned_, "1");
    content[layout::kNormalForce] = per_block(p_, "N");
    content[layout::kFriction] = per_block(tau_, "N");
    content[layout::kDisplacement] = per_block(u_x_, "m");
    content[layout::kRuptureStep] = per_row(rupture_step_, "1");
    content[layout::kRuptureTime] = per_row(rupture_time_, "s");
    content[layout::kRuptureBlock] = per_row(rupture_block_, "1");
    return content;
  }

  void clear() {
    for (auto* buffer : {&time_, &F_T_, &x_drive_, &p_, &tau_, &u_x_, &rupture_time_}) {
      buffer->clear();
    }
    for (auto* buffer : {&step_, &rupture_step_, &rupture_block_}) buffer->clear();
    pinned_.clear();
  }

 private:
  template <class T>
  static Dataset per_row(const std::vector<T>& values, const char* unit) {
    return make_array(std::span(values), {values.size()}, unit);
  }
  template <class T>
  Dataset per_block(const std::vector<T>& values, const char* unit) const {
    return make_array(std::span(values), {values.size() / Nx_, Nx_}, unit);
  }

  std::size_t Nx_;
  std::size_t flush_every_;
  std::vector<double> time_, F_T_, x_drive_, p_, tau_, u_x_, rupture_time_;
  std::vector<std::int64_t> step_, rupture_step_, rupture_block_;
  std::vector<std::uint16_t> pinned_;
};

class RecordWriter::Part : public PartFile {
  using PartFile::PartFile;
};

std::filesystem::path part_path(const std::filesystem::path& path) {
  return path.string() + ".part";
}

void check_record(const std::filesystem::path& path, const Parameters& parameters,
                  IfExists if_exists) {
  check_count_range(parameters);
  check_output(path, if_exists);
  check_output(part_path(path), if_exists);
}

RecordWriter::RecordWriter(std::filesystem::path path, const Parameters& parameters,
                           const std::vector<ProvenanceEntry>& provenance, IfExists if_exists,
                           Content rows_before, std::size_t flush_every)
    : path_(std::move(path)), if_exists_(if_exists) {
  check_record(path_, parameters, if_exists);
  buffers_ = std::make_unique<Buffers>(static_cast<std::size_t>(parameters.Nx), flush_every);
  rows_before.merge(buffers_->content());  // all datasets are there, even if without rows
  part_ = std::make_unique<Part>(part_path(path_),
                                 first_piece(parameters, provenance, std::move(rows_before)));
}

RecordWriter::~RecordWriter() = default;

void RecordWriter::append(const Sample& sample) {
  buffers_->add(sample);
  if (buffers_->full()) flush();
}

void RecordWriter::append(std::span<const Rupture> ruptures) {
  for (const Rupture& rupture : ruptures) buffers_->add(rupture);
  if (buffers_->full()) flush();
}

void RecordWriter::flush() {
  if (buffers_->empty()) return;
  Content rows = buffers_->content();
  buffers_->clear();
  std::erase_if(rows, [](const auto& entry) { return entry.second.bytes.empty(); });
  part_->append(rows);
}

void RecordWriter::sync() {
  flush();
  part_->sync();
}

std::string RecordWriter::finish(const std::vector<ProvenanceEntry>& provenance, SumFile sum) {
  flush();
  const std::filesystem::path part = part_path(path_);
  Content content = provenance_content(provenance);
  content.merge(read_content(part));
  std::string checksum = write_content(path_, FileKind::record, content, if_exists_, sum);
  remove_durably(part);
  return checksum;
}

}  // namespace rupture
