// Renews the checksums of chunks after each mutation, without which hardly any of them got past the first
// check. Some stay wrong, as that check is to be seen too.
#include <zlib.h>

#include <cstddef>
#include <cstdint>

extern "C" size_t LLVMFuzzerMutate(uint8_t* data, size_t size, size_t most);

extern "C" size_t LLVMFuzzerCustomMutator(uint8_t* data, size_t size, size_t most, unsigned seed) {
  constexpr size_t kSignature = 8, kOfChunk = 12;  // length, type, checksum
  size = LLVMFuzzerMutate(data, size, most);
  if (seed % 16 == 0) return size;
  for (size_t at = kSignature; at + kOfChunk <= size;) {
    const size_t length =
        size_t{data[at]} << 24 | size_t{data[at + 1]} << 16 | size_t{data[at + 2]} << 8 | data[at + 3];
    if (length > size - at - kOfChunk) break;
    const auto sum = static_cast<uint32_t>(crc32_z(0, data + at + 4, 4 + length));
    for (size_t i = 0; i < 4; ++i) data[at + 8 + length + i] = static_cast<uint8_t>(sum >> (24 - 8 * i));
    at += kOfChunk + length;
  }
  return size;
}
