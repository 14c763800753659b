#include "sectorgen/geo/model_tags.hpp"

#include <algorithm>
#include <cstdio>

#include "sectorgen/geo/tag_values.hpp"

namespace vicus {
namespace {

const std::map<std::string, const char*>& roof_shapes() {
  static const std::map<std::string, const char*> kShapes = {
      {"1000", "flat"},         {"1010", "skillion"},    {"1020", "saltbox"},   {"1030", "gabled"},
      {"1040", "hipped"},       {"1050", "half-hipped"}, {"1060", "mansard"},   {"1070", "pyramidal"},
      {"1080", "cone"},         {"1090", "dome"},        {"1110", "round"},     {"1120", "pyramidal"},
      {"2100", "skillion"},     {"2200", "saltbox"},     {"3100", "gabled"},    {"3200", "hipped"},
      {"3300", "half-hipped"},  {"3400", "mansard"},     {"3500", "pyramidal"}, {"3600", "cone"},
      {"3700", "dome"},         {"3900", "round"},       {"flat roof", "flat"}, {"gabled roof", "gabled"},
      {"hipped roof", "hipped"}};
  return kShapes;
}

}  // namespace

Tags model_tags(const Tags& attributes, double height_m) {
  Tags tags = {{"building", "yes"}};
  char text[32];
  std::snprintf(text, sizeof text, "%.3f", height_m);
  tags["height"] = text;
  const auto copy = [&](const char* from, const char* to) {
    if (const auto& value = tag(attributes, from); !value.empty()) tags[to] = value;
  };
  copy("name", "name");
  copy("storeysAboveGround", "building:levels");
  copy("street", "addr:street");
  copy("houseNumber", "addr:housenumber");
  copy("yearOfConstruction", "start_date");
  if (const auto levels = parse_number(tag(tags, "building:levels")); levels && *levels <= 0)
    tags.erase("building:levels");
  const auto shape = roof_shapes().find(lower_case(tag(attributes, "roofType")));
  if (shape != roof_shapes().end()) tags["roof:shape"] = shape->second;
  return tags;
}

}  // namespace vicus
