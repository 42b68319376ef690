// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/exchange/curve_keys.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <zmq.hpp>

#include "common/errors.hpp"

namespace fissura {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t key_length = 40;
constexpr mode_t secret_mode = 0600, public_mode = 0644;

// Everybody has these: they are the examples of the manual zmq_curve(7).
constexpr std::array published_keys{
    "Yne@$w-vo<fVvi]a<NY6T1ed:M$fCG*[IaLV{hID", "D:)Q[IlAW!ahhC2ac:9*A}h:p?([4%wOTJ%JR%cs",
    "rq:rM>}U?@Lns47E1%kR.o@n%FcmmsL/@{H8]yf7", "JTKVSB%%)wK0E.X)V>+}o?pNmC{O&4W4b!Ni{Lh6"};

[[noreturn]] void refuse(const fs::path& file, const std::string& what) {
  throw Error(ExitCode::security, fmt::format("{}: {}", file.string(), what));
}

class OpenFile {
 public:
  OpenFile(const fs::path& file, int flags, mode_t mode)
      : descriptor_(::open(file.c_str(), flags | O_CLOEXEC, mode)) {}
  ~OpenFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  [[nodiscard]] int descriptor() const { return descriptor_; }

 private:
  int descriptor_;
};

enum class Kind { public_key, secret_key };

void check_owner(const OpenFile& file, const fs::path& path) {
  struct stat status {};
  if (::fstat(file.descriptor(), &status) != 0) refuse(path, std::strerror(errno));
  if ((status.st_mode & (S_IRWXG | S_IRWXO)) != 0)
    refuse(path,
           fmt::format("its mode is {:o}, others could read this secret key: chmod 600 it, and make new keys "
                       "if others may have read it already",
                       status.st_mode & 07777));
  if (status.st_uid != ::geteuid() && status.st_uid != 0) refuse(path, "it belongs to another user");
}

std::string read_key(const fs::path& path, Kind kind) {
  const OpenFile file(path, O_RDONLY | O_NONBLOCK, 0);
  if (file.descriptor() < 0)
    refuse(path,
           fmt::format("{}; `coupler keys new` makes keys and says which belong here", std::strerror(errno)));
  if (kind == Kind::secret_key) check_owner(file, path);
  std::array<char, 256> bytes{};
  const ssize_t length = ::read(file.descriptor(), bytes.data(), bytes.size());
  std::string key(bytes.data(), static_cast<std::size_t>(std::max<ssize_t>(0, length)));
  while (!key.empty() && (key.back() == '\n' || key.back() == '\r')) key.pop_back();
  std::array<std::uint8_t, 32> raw{};
  if (key.size() != key_length || zmq_z85_decode(raw.data(), key.c_str()) == nullptr)
    refuse(path, "expected a key: one line of 40 characters (Z85)");
  if (std::find(published_keys.begin(), published_keys.end(), key) != published_keys.end())
    refuse(path, "this key is an example published in a manual, everybody has it: make new keys");
  return key;
}

void write_key(const fs::path& path, const std::string& key, mode_t mode) {
  const OpenFile file(path, O_WRONLY | O_CREAT | O_EXCL, mode);
  const std::string line = key + "\n";
  if (file.descriptor() < 0 || ::fchmod(file.descriptor(), mode) != 0 ||
      ::write(file.descriptor(), line.data(), line.size()) != static_cast<ssize_t>(line.size()))
    throw Error(ExitCode::precondition,
                fmt::format("cannot write {}: {}", path.string(), std::strerror(errno)));
}

fs::path file_of(const fs::path& directory, const std::string& holder, Kind kind) {
  return directory / (holder + (kind == Kind::public_key ? ".public" : ".secret"));
}

void create_private(const fs::path& directory) {
  if (fs::is_directory(directory)) return;
  if (!directory.parent_path().empty()) fs::create_directories(directory.parent_path());
  if (::mkdir(directory.c_str(), 0700) != 0)
    throw Error(ExitCode::precondition,
                fmt::format("cannot create {}: {}", directory.string(), std::strerror(errno)));
}

KeyPair pair_of(std::string secret_key) {
  std::string public_key = public_key_of(secret_key);
  return {std::move(public_key), std::move(secret_key)};
}

}  // namespace

KeyPair new_key_pair() {
  std::array<char, key_length + 1> public_key{}, secret_key{};
  if (zmq_curve_keypair(public_key.data(), secret_key.data()) != 0)
    throw Error(ExitCode::security, "this build of ZeroMQ knows no CURVE security, so there can be no keys");
  return {public_key.data(), secret_key.data()};
}

std::string public_key_of(const std::string& secret_key) {
  std::array<char, key_length + 1> public_key{};
  if (secret_key.size() != key_length || zmq_curve_public(public_key.data(), secret_key.c_str()) != 0)
    throw Error(ExitCode::security,
                "a secret key has no public one: it is damaged, or ZeroMQ knows no CURVE security");
  return public_key.data();
}

std::vector<fs::path> write_new_keys(const fs::path& directory) {
  try {
    create_private(fs::absolute(directory).lexically_normal());
    std::vector<fs::path> files;
    for (const std::string holder : key_holders)
      for (const Kind kind : {Kind::public_key, Kind::secret_key})
        files.push_back(file_of(directory, holder, kind));
    for (const fs::path& file : files)
      if (fs::exists(fs::symlink_status(file)))
        throw Error(
            ExitCode::precondition,
            fmt::format("{} exists: keys are never overwritten, choose another directory", file.string()));
    for (const std::string holder : key_holders) {
      const KeyPair pair = new_key_pair();
      write_key(file_of(directory, holder, Kind::secret_key), pair.secret_key, secret_mode);
      write_key(file_of(directory, holder, Kind::public_key), pair.public_key, public_mode);
    }
    return files;
  } catch (const fs::filesystem_error& fault) {
    throw Error(ExitCode::precondition, fmt::format("cannot write keys: {}", fault.what()));
  }
}

CouplerKeys read_coupler_keys(const fs::path& directory) {
  CouplerKeys keys;
  keys.own = pair_of(read_key(file_of(directory, "coupler", Kind::secret_key), Kind::secret_key));
  const fs::path own_public = file_of(directory, "coupler", Kind::public_key);
  if (fs::exists(own_public) && read_key(own_public, Kind::public_key) != keys.own.public_key)
    refuse(own_public,
           "it does not belong to coupler.secret beside it: the two files are of different pairs");
  for (const char* role : {"structure", "network"})
    keys.allowed.push_back({role, read_key(file_of(directory, role, Kind::public_key), Kind::public_key)});
  if (keys.allowed[0].public_key == keys.allowed[1].public_key)
    refuse(file_of(directory, "network", Kind::public_key),
           "it is the key of the structure too: each role needs its own");
  return keys;
}

ParticipantKeys read_participant_keys(const fs::path& directory, const std::string& role) {
  return {pair_of(read_key(file_of(directory, role, Kind::secret_key), Kind::secret_key)),
          read_key(file_of(directory, "coupler", Kind::public_key), Kind::public_key)};
}

}  // namespace fissura
