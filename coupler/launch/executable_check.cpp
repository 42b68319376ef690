// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/launch/executable_check.hpp"

#include <elf.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>

namespace fissura::coupler {

namespace {

/// The first word of a shell command without its quotes; nothing if it takes the shell to know it.
std::optional<std::string> first_word(const std::string& command) {
  std::string word;
  char quote = '\0';
  const std::size_t begin = command.find_first_not_of(" \t");
  for (std::size_t i = begin; i < command.size(); ++i) {
    const char c = command[i];
    if (quote != '\0') {
      if (c == quote)
        quote = '\0';
      else if (quote == '"' && std::strchr("$`\\", c) != nullptr)
        return std::nullopt;
      else
        word += c;
    } else if (c == '\'' || c == '"') {
      quote = c;
    } else if (c == ' ' || c == '\t') {
      break;
    } else if (std::strchr("$`\\*?[]{}()<>|&;#~\n", c) != nullptr) {
      return std::nullopt;
    } else {
      word += c;
    }
  }
  if (word.empty() || quote != '\0') return std::nullopt;
  return word;
}

using Header = std::array<char, sizeof(Elf64_Ehdr)>;

Header header_of(const std::string& file) {
  Header bytes{};
  std::ifstream(file, std::ios::binary).read(bytes.data(), bytes.size());
  return bytes;
}

/// The kind of processor, and whether the words are of 32 or 64 bits.
bool same_machine(const Header& one, const Header& other) {
  constexpr std::size_t machine = offsetof(Elf64_Ehdr, e_machine);
  return one[EI_CLASS] == other[EI_CLASS] && one[EI_DATA] == other[EI_DATA] &&
         one[machine] == other[machine] && one[machine + 1] == other[machine + 1];
}

std::optional<std::string> fault_of(const std::string& file) {
  struct stat information {};
  if (::stat(file.c_str(), &information) != 0) return fmt::format("{}: {}", file, ::strerror(errno));
  if (!S_ISREG(information.st_mode)) return fmt::format("{}: not a file", file);
  if (::access(file.c_str(), X_OK) != 0) return fmt::format("{}: {}", file, ::strerror(errno));
  const Header header = header_of(file);
  if (std::memcmp(header.data(), ELFMAG, SELFMAG) == 0 && !same_machine(header, header_of("/proc/self/exe")))
    return fmt::format("{}: {}, it was built for another kind of processor", file, ::strerror(ENOEXEC));
  return std::nullopt;
}

}  // namespace

std::optional<std::string> why_not_executable(const std::string& command) {
  const std::optional<std::string> word = first_word(command);
  if (!word) return std::nullopt;
  if (word->find('/') != std::string::npos) return fault_of(*word);
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "/usr/bin:/bin" : path);
  for (std::string folder; std::getline(folders, folder, ':');)
    if (::access((folder + "/" + *word).c_str(), X_OK) == 0) return fault_of(folder + "/" + *word);
  return fmt::format("{}: not found in PATH", *word);
}

}  // namespace fissura::coupler
