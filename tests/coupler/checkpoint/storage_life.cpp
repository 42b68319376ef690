// SPDX-License-Identifier: GPL-3.0-or-later
// storage_life DIRECTORY LAST: one life of a run that only writes, to interval LAST, with a checkpoint after
// every second interval; it goes on from the newest usable checkpoint of DIRECTORY. A line on stdout after
// each checkpoint and at the end; ends with the exit code of its failure. The calls of the system that count
// come after a look for the file "storage_life begins". storage_life DIRECTORY: tells the newest usable
// checkpoint and what is wrong with others, changing nothing.
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "common/errors.hpp"
#include "coupler/checkpoint/checkpoint_store.hpp"
#include "tests/coupler/checkpoint/sample_checkpoint.hpp"
#include "tests/coupler/record/scripted_run.hpp"

using namespace fissura;
using namespace fissura::coupler;

namespace {

constexpr std::uint64_t checkpoint_every = 2;

void say(const char* what, std::uint64_t interval) {
  std::printf("%s %llu\n", what, static_cast<unsigned long long>(interval));
  std::fflush(stdout);
}

std::vector<std::byte> bytes_of(std::uint64_t number) {
  std::vector<std::byte> bytes(1 << 16);
  for (std::size_t i = 0; i + sizeof(number) <= bytes.size(); i += sizeof(number))
    std::memcpy(bytes.data() + i, &number, sizeof(number));
  return bytes;
}

/// Every state must be of the interval of the manifest: a mixed checkpoint would not be.
std::optional<std::string> reason_against(const std::filesystem::path& directory,
                                          const Checkpoint& checkpoint) {
  for (const char* state : {"scheme", "structure", "network"})
    if (checkpoint.states.at(state) != bytes_of(checkpoint.manifest.interval)) return "MIXED";
  try {
    RunRecord::check(directory, checkpoint.states.at("record"));
  } catch (const Error& fault) {
    return fault.what();
  }
  return std::nullopt;
}

FoundCheckpoint found_in(const std::filesystem::path& directory) {
  return CheckpointStore(directory, 2).newest_usable([&](const Checkpoint& checkpoint) {
    return reason_against(directory, checkpoint);
  });
}

void write_checkpoint(CheckpointStore& store, RunRecord& record, std::uint64_t interval) {
  Checkpoint checkpoint;
  checkpoint.manifest.provenance = sample::provenance();
  checkpoint.manifest.interval = interval;
  for (const char* state : {"scheme", "structure", "network"}) checkpoint.states[state] = bytes_of(interval);
  checkpoint.states["record"] = record.save();
  store.write(std::move(checkpoint));
  say("checkpoint", interval);
}

void live(const std::filesystem::path& directory, std::uint64_t last) {
  CheckpointStore store(directory, 2);
  const FoundCheckpoint found = found_in(directory);
  RunRecord record(directory, sample::reports_per_segment);
  std::uint64_t interval = 0;
  if (found.checkpoint) {
    interval = found.checkpoint->manifest.interval;
    store.set_aside_newer_than(interval);
    record.resume(sample::description(), found.checkpoint->states.at("record"));
  } else {
    store.set_aside_newer_than(std::nullopt);
    record.begin(sample::description());
  }
  say("from", interval);
  while (interval < last) {
    sample::record_interval(record, ++interval);
    if (interval % checkpoint_every == 0) write_checkpoint(store, record, interval);
  }
  record.finish({{"verdict", "none"}, {"intervals", last}});
  say("done", interval);
}

void tell(const std::filesystem::path& directory) {
  const FoundCheckpoint found = found_in(directory);
  for (const UnusableCheckpoint& other : found.unusable)
    std::printf("unusable %s: %s\n", other.name.c_str(), other.reason.c_str());
  if (found.checkpoint) say("newest", found.checkpoint->manifest.interval);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2 || argc > 3) return static_cast<int>(ExitCode::command_line);
  try {
    if (argc == 2) {
      tell(argv[1]);
    } else {
      (void)::access("storage_life begins", F_OK);
      live(argv[1], std::strtoull(argv[2], nullptr, 10));
    }
    return 0;
  } catch (const Error& failure) {
    std::fprintf(stderr, "%s\n", failure.what());
    return static_cast<int>(failure.code());
  } catch (const std::filesystem::filesystem_error& failure) {
    // As the worker of a run tells it.
    std::fprintf(stderr, "%s\n", failure.what());
    return static_cast<int>(ExitCode::storage_failure);
  } catch (const std::exception& failure) {
    std::fprintf(stderr, "unexpected: %s\n", failure.what());
    return static_cast<int>(ExitCode::internal);
  }
}
