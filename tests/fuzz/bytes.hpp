// The bytes that a fuzzer made up, taken one after another.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>

namespace rupture::fuzz {

class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : at_(data), end_(data + size) {}

  bool empty() const { return at_ == end_; }

  /// The next number; zeros stand in for what is missing at the end.
  template <class T>
  T take() {
    T value{};
    const std::size_t size = std::min(sizeof(T), left());
    if (size > 0) std::memcpy(&value, at_, size);
    at_ += size;
    return value;
  }

  /// One of `choices`, which must not be empty.
  template <class Choices>
  const auto& pick(const Choices& choices) {
    return *std::next(std::begin(choices),
                      static_cast<std::ptrdiff_t>(take<std::uint8_t>() % std::size(choices)));
  }

  /// A text of up to 255 bytes, its length first.
  std::string text() {
    const std::size_t wanted = take<std::uint8_t>();
    const std::size_t size = std::min(wanted, left());
    std::string text(reinterpret_cast<const char*>(at_), size);
    at_ += size;
    return text;
  }

 private:
  std::size_t left() const { return static_cast<std::size_t>(end_ - at_); }

  const std::uint8_t* at_;
  const std::uint8_t* end_;
};

}  // namespace rupture::fuzz
