// Any bytes, as a file: the reader either refuses them with a Failure or returns what they hold.
#include "rupture/checkpoint/file.hpp"
#include "rupture/model/error.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    rupture::read_bytes(std::as_bytes(std::span(data, size)), "x.h5");
  } catch (const rupture::Failure&) {
  }
  return 0;
}
