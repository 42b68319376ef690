// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/hash.hpp"

#include <libdeflate.h>
#include <openssl/evp.h>

#include <array>
#include <fstream>
#include <memory>
#include <vector>

#include "common/errors.hpp"

namespace fissura {

namespace {

class Sha256 {
 public:
  Sha256() : context_(EVP_MD_CTX_new(), &EVP_MD_CTX_free) {
    ENSURE(EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr) == 1);
  }
  void add(const void* bytes, std::size_t count) {
    ENSURE(EVP_DigestUpdate(context_.get(), bytes, count) == 1);
  }
  std::string hexadecimal() {
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    unsigned int length = 0;
    ENSURE(EVP_DigestFinal_ex(context_.get(), digest.data(), &length) == 1);
    constexpr char digits[] = "0123456789abcdef";
    std::string text;
    for (unsigned int i = 0; i < length; ++i) {
      text += digits[digest[i] >> 4];
      text += digits[digest[i] & 15];
    }
    return text;
  }

 private:
  std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context_;
};

}  // namespace

std::uint32_t crc32(std::span<const std::byte> bytes, std::uint32_t start) {
  // libdeflate takes a null pointer for the wish to start anew.
  if (bytes.empty()) return start;
  return libdeflate_crc32(start, bytes.data(), bytes.size());
}

std::string sha256(std::span<const std::byte> bytes) {
  Sha256 sum;
  sum.add(bytes.data(), bytes.size());
  return sum.hexadecimal();
}

std::string sha256_of_file(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw StorageError("cannot read " + file.string());
  Sha256 sum;
  std::vector<char> block(1 << 16);
  while (stream.read(block.data(), static_cast<std::streamsize>(block.size())), stream.gcount() > 0)
    sum.add(block.data(), static_cast<std::size_t>(stream.gcount()));
  if (stream.bad()) throw StorageError("cannot read " + file.string());
  return sum.hexadecimal();
}

}  // namespace fissura
