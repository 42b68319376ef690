// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/coupler/seismicity/sample_sources.hpp"

#include <random>

#include "common/byte_archive.hpp"

namespace fissura::coupler::test {

std::vector<std::byte> bytes_of(const std::vector<SeismicEvent>& events) {
  ByteWriter writer;
  for (const SeismicEvent& e : events) {
    writer.put(e.id);
    writer.put(std::vector<double>{e.origin_time, e.centroid_time, e.duration, e.origin[0], e.origin[1],
                                   e.centroid[0], e.centroid[1]});
    writer.put(e.moment);
    writer.put(e.pseudo_moment);
    writer.put(std::vector<double>{e.scalar_moment, e.scalar_sum, e.coherence, e.magnitude.value_or(-99)});
    writer.put(
        std::vector<double>{e.shares.iso, e.shares.clvd, e.shares.dc, e.hudson.u, e.hudson.v, e.slope});
    writer.put(e.type);
    writer.put(e.normal);
    writer.put(std::vector<double>{e.plane.strike, e.plane.dip, e.plane.rake, e.auxiliary_plane.strike,
                                   e.auxiliary_plane.dip, e.auxiliary_plane.rake});
    writer.put(std::vector<double>{e.area, e.slip, e.opening, e.stress_drop, e.radius, e.length, e.thickness,
                                   e.element_size, e.peak_rate, e.fluid_pressure, e.radius_of_clustering,
                                   e.time_of_clustering});
    writer.put(e.fracture);
    writer.put(e.line);
    writer.put(std::vector<std::uint64_t>{e.sources, e.records, e.interval});
  }
  return writer.take();
}

std::vector<SourceRecord> random_records(std::uint64_t seed, int intervals) {
  std::mt19937_64 random(seed);
  const auto uniform = [&random] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  std::vector<SourceRecord> records;
  for (int k = 0; k < intervals; ++k) {
    const double scale = k % 7 == 0 ? 100 : 1;
    for (std::uint64_t entity = 0; entity < 40; ++entity) {
      if (uniform() > (entity % 5 == 0 ? 0.9 : 0.2)) continue;
      const bool slips = entity % 2 == 0;
      SourceRecord record = joint_record(slips ? SourceKind::contact_slip : SourceKind::new_crack, entity, 0,
                                         {static_cast<double>(entity % 8), static_cast<double>(entity / 8)},
                                         {1e-3 * (uniform() - 0.3), slips ? 0 : 1e-3 * uniform()});
      if (entity % 3 == 0) {
        record.kind = slips ? SourceKind::bulk_shear : SourceKind::bulk_tension;
        record.fracture = SourceFracture::none;
        record.geometry = static_cast<std::uint64_t>(k) / 50;
        record.jump = {};
      }
      record.begin = random_interval * (k + 0.4 * uniform());
      record.end = record.begin + 0.5 * random_interval * uniform();
      if (uniform() < 0.1) record.begin = std::max(0.0, record.begin - 20 * random_interval * uniform());
      record.centroid_time = 0.5 * (record.begin + record.end);
      record.interval = static_cast<std::uint64_t>(k) + 1;
      record.element_size = 0.4 + 0.05 * static_cast<double>(entity % 13);
      record.peak_rate = uniform() < 0.2 ? 1e-5 : 1e-2;
      record.shear_after = uniform() < 0.3 ? record.shear_before : 0;
      record.failing = uniform() < 0.9;
      record.mass_scale = scale;
      record.fluid_pressure = 1e7 * uniform();
      for (double& component : record.pseudo_moment) component = 1e5 * (uniform() - 0.5);
      records.push_back(record);
    }
  }
  return records;
}

}  // namespace fissura::coupler::test
