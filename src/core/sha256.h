// SHA-256 (FIPS 180-4), by libmd.
#pragma once

#include <sha256.h>

#include <cstddef>
#include <string>
#include <string_view>

namespace weir {

class Sha256 {
 public:
  Sha256();
  void add(const void* bytes, std::size_t count);
  std::string hex();  // ends the computation

 private:
  SHA256_CTX state_{};
};

std::string sha256(std::string_view text);  // 64 hexadecimal digits

}  // namespace weir
