#include "rupture/checkpoint/checksum.hpp"

#include <openssl/evp.h>

#include <algorithm>
#include <memory>

#include "rupture/checkpoint/parameters_content.hpp"

namespace rupture {
namespace {

constexpr std::string_view kParameters = "/parameters/";
constexpr std::array<std::string_view, 6> kChecksummedGroups = {
    kParameters, "/state/", "/series/", "/ruptures/", "/crossings/", "/fields/"};
constexpr std::string_view kCanonicalForm = "rupture content 1\n";

void check(int success) {
  if (success != 1) throw Failure("OpenSSL could not compute a SHA-256; is its library intact?");
}

// Running SHA-256 of a sequence of bytes.
class Sha256 {
 public:
  Sha256() { check(EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr)); }

  void update(std::span<const std::byte> bytes) {
    check(EVP_DigestUpdate(context_.get(), bytes.data(), bytes.size()));
  }

  // Ends the sequence.
  std::string hex() {
    std::array<unsigned char, 32> digest{};
    check(EVP_DigestFinal_ex(context_.get(), digest.data(), nullptr));
    return fmt::format("{:02x}", fmt::join(digest, ""));
  }

 private:
  std::unique_ptr<EVP_MD_CTX, void (*)(EVP_MD_CTX*)> context_{EVP_MD_CTX_new(), &EVP_MD_CTX_free};
};

void update_number(Sha256& hash, std::uint64_t number) {
  hash.update(std::as_bytes(std::span(&number, 1)));  // little-endian: see content.cpp
}

void update_prefixed(Sha256& hash, std::span<const std::byte> bytes) {
  update_number(hash, bytes.size());
  hash.update(bytes);
}

void update_dataset(Sha256& hash, const std::string& path, const Dataset& dataset) {
  update_prefixed(hash, std::as_bytes(std::span(path)));
  update_prefixed(hash, std::as_bytes(std::span(type_name(dataset.type))));
  update_number(hash, dataset.shape.size());
  for (const std::uint64_t length : dataset.shape) update_number(hash, length);
  update_prefixed(hash, dataset.bytes);
}

}  // namespace

std::string sha256(std::span<const std::byte> bytes) {
  Sha256 hash;
  hash.update(bytes);
  return hash.hex();
}

bool is_checksummed(std::string_view path) {
  if (path.ends_with("/x") || path.ends_with("/z")) return false;
  return std::ranges::any_of(kChecksummedGroups,
                             [&](std::string_view group) { return path.starts_with(group); });
}

std::string content_checksum(const Content& content) {
  const Content parameters = counted_parameters(content);
  std::map<std::string, const Dataset*> sorted;
  for (const auto& [path, dataset] : parameters) sorted.emplace(path, &dataset);
  for (const auto& [path, dataset] : content) {
    if (is_checksummed(path) && !path.starts_with(kParameters)) sorted.emplace(path, &dataset);
  }
  Sha256 hash;
  hash.update(std::as_bytes(std::span(kCanonicalForm)));
  for (const auto& [path, dataset] : sorted) update_dataset(hash, path, *dataset);
  return hash.hex();
}

std::string labelled(const std::string& checksum) {
  return "content-sha256 " + checksum;
}

}  // namespace rupture
