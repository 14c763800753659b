#include <limits>

#include "x3d_export/city_index.hpp"

namespace vicus {

RecordSource source_of(const CityReader& reader) {
  RecordSource source;
  source.sector = [&reader](const std::string& id) { return reader.sector(id); };
  source.gates_of = [&reader](const std::string& id) { return reader.gates_of(id); };
  source.viewpoints_of = [&reader](const std::string& id) { return reader.viewpoints_of(id); };
  source.objects_of = [&reader](const std::string& id) { return reader.objects_of(id); };
  source.visible_from = [&reader](const std::string& id) { return reader.visible_from(id); };
  source.houses_in = [&reader](const PlanBox& box) {
    return reader.buildings_in(box, std::numeric_limits<std::int32_t>::max(), 0);
  };
  source.sector_ids = [&reader] { return reader.sector_ids(); };
  source.meta = [&reader](const std::string& key) { return reader.meta(key).value_or(""); };
  return source;
}

}  // namespace vicus
