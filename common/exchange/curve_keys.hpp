// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

/// Long-term keys of CurveZMQ (https://rfc.zeromq.org/spec/26), one pair for each of coupler, structure and
/// network, as text of 40 characters (Z85, https://rfc.zeromq.org/spec/32). Each lies in two files of one
/// line, HOLDER.public and HOLDER.secret.
namespace fissura {

struct KeyPair {
  std::string public_key, secret_key;
};

/// A new pair from the random source of the system.
KeyPair new_key_pair();

/// The public key that belongs to a secret one. Throws Error(security) if it is no key.
std::string public_key_of(const std::string& secret_key);

/// A participant's public key and the only role it may claim.
struct AllowedKey {
  std::string role, public_key;
};

/// What the coupler needs: its own pair, and whom it lets in.
struct CouplerKeys {
  KeyPair own;
  std::vector<AllowedKey> allowed;
};

/// What a participant needs: its own pair, and the coupler it will talk to.
struct ParticipantKeys {
  KeyPair own;
  std::string coupler_public_key;
};

/// "coupler", "structure", "network".
inline constexpr std::array<const char*, 3> key_holders{"coupler", "structure", "network"};

/// Writes a new pair for each holder into `directory`, which is created with mode 0700 if it does not exist;
/// secrets have mode 0600. Throws Error(precondition) if one of the files exists already, before any is
/// written.
/// @returns the files written
std::vector<std::filesystem::path> write_new_keys(const std::filesystem::path& directory);

/// Reads coupler.secret, structure.public and network.public. Throws Error(security), naming the file and
/// what to do, if one is missing, holds no key or a published one, if others than its owner could read or
/// change a secret, or if coupler.public is there and is not that of the secret.
CouplerKeys read_coupler_keys(const std::filesystem::path& directory);

/// Reads ROLE.secret and coupler.public, with the same checks. @param role  "structure" or "network"
ParticipantKeys read_participant_keys(const std::filesystem::path& directory, const std::string& role);

}  // namespace fissura
