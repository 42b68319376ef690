// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/checkpoint/manifest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <span>
#include <string_view>

#include "common/errors.hpp"
#include "common/exact_json.hpp"
#include "common/hash.hpp"

namespace fissura::coupler {

namespace {

constexpr int schema = 1;
constexpr const char* network_role = "network";
constexpr std::string_view before_hash = "  \"sha256\": \"", after_hash = "\"\n}\n";
constexpr std::size_t hash_digits = 64;
constexpr std::size_t tail = before_hash.size() + hash_digits + after_hash.size();

[[noreturn]] void refuse(const std::string& sentence) {
  throw Error(ExitCode::checkpoint_unusable, sentence);
}

std::string hash_of(std::string_view text) {
  return sha256(std::as_bytes(std::span(text)));
}

/// Names become file names.
bool is_plain_word(std::string_view name) {
  return !name.empty() && name.size() <= hash_digits &&
         std::all_of(name.begin(), name.end(),
                     [](char letter) { return (letter >= 'a' && letter <= 'z') || letter == '_'; });
}

std::string_view sealed_part(const std::string& text) {
  if (text.size() < tail) refuse("it is too short to be a manifest");
  const std::string_view whole = text, head = whole.substr(0, text.size() - tail);
  const std::string_view end = whole.substr(head.size());
  if (end != fmt::format("{}{}{}", before_hash, hash_of(head), after_hash))
    refuse("its hash does not fit its text");
  return head;
}

std::string unsealed_text(const Manifest& manifest) {
  nlohmann::ordered_json json;
  json["schema"] = schema;
  json["run_id"] = manifest.provenance.run_id;
  json["case_hash"] = manifest.provenance.case_hash;
  json["program"] = manifest.provenance.program;
  json["participants"] = manifest.provenance.participants;
  json["threads"] = manifest.provenance.threads;
  json["epoch"] = manifest.epoch;
  json["interval"] = manifest.interval;
  json["time"] = manifest.time;
  json["revision"] = manifest.revision;
  json["topology_hash"] = manifest.topology_hash;
  json["files"] = nlohmann::ordered_json::object();
  for (const auto& [name, file] : manifest.files)
    json["files"][name] = {{"bytes", file.bytes}, {"sha256", file.sha256}};
  std::string text = json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  text.erase(text.rfind('\n'));
  return text + ",\n";
}

}  // namespace

std::optional<std::string> mismatch(const Provenance& wrote, const Provenance& run) {
  if (wrote.run_id != run.run_id)
    return fmt::format("of another run ({}, this is {})", wrote.run_id, run.run_id);
  if (wrote.case_hash != run.case_hash)
    return fmt::format("of another case (hash {:.8}..., this is {:.8}...)", wrote.case_hash, run.case_hash);
  if (wrote.program != run.program)
    return fmt::format("of another program ({}, this is {})", wrote.program, run.program);
  for (const auto& [role, solver] : run.participants) {
    if (role == network_role) continue;
    const auto found = wrote.participants.find(role);
    if (found == wrote.participants.end() || found->second != solver)
      return fmt::format("of another {} ({}, this is {})", role,
                         found == wrote.participants.end() ? "none" : found->second, solver);
  }
  return std::nullopt;
}

std::optional<NetworkChange> network_change(const Manifest& wrote, const std::string& network,
                                            std::uint32_t commanded_since) {
  const auto found = wrote.provenance.participants.find(network_role);
  const std::string before = found == wrote.provenance.participants.end() ? "none" : found->second;
  if (before == network && wrote.epoch >= commanded_since) return std::nullopt;
  return NetworkChange{wrote.interval, wrote.time, before, network};
}

std::string manifest_text(const Manifest& manifest) {
  const std::string head = unsealed_text(manifest);
  return fmt::format("{}{}{}{}", head, before_hash, hash_of(head), after_hash);
}

Manifest manifest_from_text(const std::string& text) {
  (void)sealed_part(text);
  try {
    const auto json = nlohmann::json::parse(text);
    if (json.at("schema") != schema)
      refuse(fmt::format("it is of schema {}, this program reads {}", json.at("schema").dump(), schema));
    Manifest manifest;
    json.at("run_id").get_to(manifest.provenance.run_id);
    json.at("case_hash").get_to(manifest.provenance.case_hash);
    json.at("program").get_to(manifest.provenance.program);
    json.at("participants").get_to(manifest.provenance.participants);
    manifest.provenance.threads = exactly<decltype(manifest.provenance.threads)>(json.at("threads"));
    manifest.epoch = exactly<decltype(manifest.epoch)>(json.at("epoch"));
    manifest.interval = exactly<decltype(manifest.interval)>(json.at("interval"));
    json.at("time").get_to(manifest.time);
    manifest.revision = exactly<decltype(manifest.revision)>(json.at("revision"));
    json.at("topology_hash").get_to(manifest.topology_hash);
    for (const auto& [name, file] : json.at("files").items()) {
      if (!is_plain_word(name)) refuse(fmt::format("\"{}\" is no name of a state", name));
      manifest.files[name] = {exactly<std::uint64_t>(file.at("bytes")), file.at("sha256").get<std::string>()};
    }
    return manifest;
  } catch (const nlohmann::json::exception& fault) {
    refuse(fmt::format("it is not complete: {}", fault.what()));
  }
}

}  // namespace fissura::coupler
