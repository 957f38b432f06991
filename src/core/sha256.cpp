#include "core/sha256.h"

#include <array>
#include <cstdint>

namespace weir {

Sha256::Sha256() { SHA256Init(&state_); }

void Sha256::add(const void* bytes, std::size_t count) {
  SHA256Update(&state_, static_cast<const std::uint8_t*>(bytes), count);
}

std::string Sha256::hex() {
  std::array<char, SHA256_DIGEST_STRING_LENGTH> text{};
  SHA256End(&state_, text.data());
  return text.data();
}

std::string sha256(std::string_view text) {
  Sha256 hash;
  hash.add(text.data(), text.size());
  return hash.hex();
}

}  // namespace weir
