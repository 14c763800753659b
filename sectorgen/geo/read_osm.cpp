#include "sectorgen/geo/read_osm.hpp"

#include <algorithm>
#include <map>
#include <osmium/area/assembler.hpp>
#include <osmium/handler/node_locations_for_ways.hpp>
#include <osmium/index/map/flex_mem.hpp>
#include <osmium/io/any_input.hpp>
#include <osmium/visitor.hpp>
#include <set>
#include <unordered_map>
#include <unordered_set>

#include "sectorgen/geo/osm_rules.hpp"
#include "sectorgen/geo/tag_values.hpp"

namespace vicus {

namespace {

using LocationIndex = osmium::index::map::FlexMem<osmium::unsigned_object_id_type, osmium::Location>;
using LocationHandler = osmium::handler::NodeLocationsForWays<LocationIndex>;
using ObjectId = osmium::object_id_type;

Tags tags_of(const osmium::OSMObject& object) {
  Tags tags;
  for (const osmium::Tag& tag : object.tags()) tags.emplace(tag.key(), tag.value());
  return tags;
}

std::string way_name(ObjectId id) { return "way/" + std::to_string(id); }

LatLon degrees(osmium::Location location) { return {location.lat_without_check(), location.lon_without_check()}; }

/// The nodes whose places are known, without a repeated last one where the way is closed.
template <typename Nodes>
std::vector<LatLon> located(const Nodes& nodes) {
  std::vector<LatLon> line;
  for (const osmium::NodeRef& node : nodes)
    if (node.location().valid()) line.push_back(degrees(node.location()));
  return line;
}

template <typename Nodes>
bool is_whole(const Nodes& nodes) {
  return std::all_of(nodes.begin(), nodes.end(), [](const osmium::NodeRef& n) { return n.location().valid(); });
}

bool is_visible(const osmium::OSMObject& object) { return object.visible() && !object.deleted(); }

/// First pass: which relations make polygons, and which ways they need.
struct RelationCollector : osmium::handler::Handler {
  osmium::memory::Buffer kept{1 << 16, osmium::memory::Buffer::auto_grow::yes};
  std::set<ObjectId> member_ways;

  void relation(const osmium::Relation& relation) {
    const char* type = relation.tags()["type"];
    if (!type || !is_visible(relation)) return;
    const bool is_multipolygon = std::string_view(type) == "multipolygon";
    Tags tags = tags_of(relation);
    tags.erase("type");
    if (!is_multipolygon) return;
    // Without tags of its own it is of the old style: its outer ways say what it is.
    if (!tags.empty() && !theme_of_polygon(tags)) return;
    kept.add_item(relation);
    kept.commit();
    for (const osmium::RelationMember& member : relation.members())
      if (member.type() == osmium::item_type::way) member_ways.insert(member.ref());
  }
};

/// Why a multipolygon could not be assembled.
struct FirstProblem : osmium::area::ProblemReporter {
  IssueCode code = IssueCode::ring_self_intersection;
  osmium::Location at;
  bool found = false;

  void set(IssueCode problem, osmium::Location where) {
    if (found) return;
    found = true;
    code = problem;
    at = where;
  }
  void report_intersection(ObjectId, osmium::Location, osmium::Location, ObjectId, osmium::Location, osmium::Location,
                           osmium::Location where) override {
    set(IssueCode::ring_self_intersection, where);
  }
  void report_ring_not_closed(const osmium::NodeRef& node, const osmium::Way*) override {
    set(IssueCode::ring_open, node.location());
  }
};

/// Second pass: nodes, ways, and the member ways of the relations.
struct FeatureCollector : osmium::handler::Handler {
  RawMap& map;
  const std::set<ObjectId>& member_ways;
  osmium::memory::Buffer members{1 << 20, osmium::memory::Buffer::auto_grow::yes};
  std::map<ObjectId, std::size_t> member_offsets;
  std::map<ObjectId, std::vector<std::size_t>> features_of_member;  // indices into map.features

  struct BarrierWay {
    std::size_t feature;
    std::vector<std::pair<ObjectId, LatLon>> nodes;
  };
  std::vector<BarrierWay> barriers;
  std::unordered_set<ObjectId> opening_nodes;
  std::unordered_set<ObjectId> walked_nodes;
  std::size_t objects_seen = 0;

  FeatureCollector(RawMap& raw_map, const std::set<ObjectId>& ways) : map(raw_map), member_ways(ways) {}

  void issue(IssueCode code, const std::string& message, const std::string& source_id, const std::vector<LatLon>& at) {
    map.issues.push_back({code, message, source_id, at.empty() ? LatLon{} : at.front(), !at.empty()});
  }

  void node(const osmium::Node& node) {
    ++objects_seen;
    if (node.tags().empty() || !is_visible(node) || !node.location().valid()) return;
    Tags tags = tags_of(node);
    if (is_opening(tags)) opening_nodes.insert(node.id());
    if (kind_of_point(tags).empty()) return;
    map.features.push_back(
        {Theme::object, "node/" + std::to_string(node.id()), std::move(tags), {{degrees(node.location())}}, {}, false});
  }

  void way(const osmium::Way& way) {
    ++objects_seen;
    if (!is_visible(way)) return;
    const bool is_member = member_ways.count(way.id()) > 0;
    if (is_member) {
      member_offsets[way.id()] = members.committed();
      members.add_item(way);
      members.commit();
    }
    if (way.tags().empty()) return;
    const std::size_t first = map.features.size();
    read_way(way, tags_of(way));
    if (!is_member) return;
    for (std::size_t i = first; i < map.features.size(); ++i) features_of_member[way.id()].push_back(i);
  }

  void read_way(const osmium::Way& way, const Tags& tags) {
    if (is_walked_way(tags))
      for (const osmium::NodeRef& node : way.nodes()) walked_nodes.insert(node.ref());
    if (tag(tags, "type") == "multipolygon") return;
    const auto line_theme = theme_of_line(tags);
    const auto polygon_theme = tag(tags, "area") == "no" ? std::nullopt : theme_of_polygon(tags);
    const bool is_house = polygon_theme == Theme::building || polygon_theme == Theme::part;
    const bool is_polygon = polygon_theme && (!line_theme || (!way.nodes().empty() && way.is_closed()));
    // A fenced park is both; a wall that is tagged as a house is the house.
    if (is_polygon) add_ring(way, *polygon_theme, tags);
    if (line_theme && !(is_polygon && is_house)) add_line(way, *line_theme, tags);
  }

  void add_line(const osmium::Way& way, Theme theme, const Tags& tags) {
    const std::string id = way_name(way.id());
    std::vector<LatLon> line = located(way.nodes());
    if (!is_whole(way.nodes()) && theme != Theme::track)
      issue(IssueCode::incomplete_relation, "Some nodes of this way are missing; it was read without them.", id, line);
    if (theme == Theme::barrier) {
      BarrierWay barrier{map.features.size(), {}};
      for (const osmium::NodeRef& node : way.nodes())
        if (node.location().valid()) barrier.nodes.emplace_back(node.ref(), degrees(node.location()));
      barriers.push_back(std::move(barrier));
    }
    map.features.push_back({theme, id, tags, {std::move(line)}, {}, false});
  }

  void add_ring(const osmium::Way& way, Theme theme, const Tags& tags) {
    const std::string id = way_name(way.id());
    std::vector<LatLon> ring = located(way.nodes());
    if (!is_whole(way.nodes())) {
      issue(IssueCode::incomplete_relation, "Some nodes of this way are missing; it was left out.", id, ring);
      return;
    }
    if (way.nodes().empty()) return;
    if (!way.is_closed() && way.nodes().front().location() != way.nodes().back().location()) {
      issue(IssueCode::ring_open, "The outline is not closed; it was closed by a straight line.", id, ring);
    } else {
      ring.pop_back();
    }
    map.features.push_back({theme, id, tags, {std::move(ring)}, {}, false});
  }

  void find_openings() {
    for (const BarrierWay& barrier : barriers)
      for (const auto& [node, at] : barrier.nodes)
        if (opening_nodes.count(node) || walked_nodes.count(node)) map.features[barrier.feature].openings.push_back(at);
  }
};

/// Polygons of the relations, after both passes.
class RelationReader {
 public:
  RelationReader(RawMap& map, FeatureCollector& ways) : map_(map), ways_(ways), gone_(map.features.size(), false) {}

  void read(const osmium::Relation& relation) {
    relation_id_ = "relation/" + std::to_string(relation.id());
    tags_ = tags_of(relation);
    tags_.erase("type");
    members_.clear();
    bool is_incomplete = false;
    for (const osmium::RelationMember& member : relation.members()) {
      if (member.type() != osmium::item_type::way) continue;
      const auto found = ways_.member_offsets.find(member.ref());
      if (found == ways_.member_offsets.end()) {
        is_incomplete = true;
      } else {
        const auto& way = ways_.members.get<const osmium::Way>(found->second);
        is_incomplete = is_incomplete || !is_whole(way.nodes());
        members_.push_back({&way, std::string(member.role())});
      }
    }
    if (tags_.empty()) take_tags_of_outer_ways();
    const auto theme = theme_of_polygon(tags_);
    if (!theme) return;
    theme_ = *theme;
    if (is_incomplete) return read_incomplete();
    assemble(relation);
  }

  /// Leaves out the ways that a relation stands for.
  void drop_replaced_ways() {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < map_.features.size(); ++i) {
      if (i < gone_.size() && gone_[i]) continue;
      if (kept != i) map_.features[kept] = std::move(map_.features[i]);
      ++kept;
    }
    map_.features.resize(kept);
  }

 private:
  struct Member {
    const osmium::Way* way;
    std::string role;
    bool is_inner() const { return role == "inner"; }
  };

  void issue(IssueCode code, const std::string& message, osmium::Location at) {
    if (!at.valid())
      for (const Member& member : members_)
        for (const osmium::NodeRef& node : member.way->nodes())
          if (!at.valid() && node.location().valid()) at = node.location();
    map_.issues.push_back({code, message, relation_id_, at.valid() ? degrees(at) : LatLon{}, at.valid()});
  }

  void take_tags_of_outer_ways() {
    for (const Member& member : members_)
      if (!member.is_inner() && theme_of_polygon(tags_of(*member.way))) {
        tags_ = tags_of(*member.way);
        return;
      }
  }

  /// An outer way with the relation's own theme is the same thing mapped twice.
  void mark_replaced_ways() {
    for (const Member& member : members_) {
      if (member.is_inner()) continue;
      const auto found = ways_.features_of_member.find(member.way->id());
      if (found == ways_.features_of_member.end()) continue;
      for (std::size_t feature : found->second)
        if (map_.features[feature].theme == theme_) gone_[feature] = true;
    }
  }

  void assemble(const osmium::Relation& relation) {
    FirstProblem problem;
    osmium::area::AssemblerConfig config;
    config.problem_reporter = &problem;
    config.create_empty_areas = false;
    osmium::memory::Buffer out{1 << 14, osmium::memory::Buffer::auto_grow::yes};
    std::vector<const osmium::Way*> ways;
    for (const Member& member : members_) ways.push_back(member.way);
    osmium::area::Assembler assembler{config};
    const bool is_whole = !ways.empty() && assembler(relation, ways, out);
    std::size_t polygons = 0;
    if (is_whole)
      for (const osmium::Area& area : out.select<osmium::Area>()) polygons += add_area(area);
    if (polygons > 0) return mark_replaced_ways();
    issue(problem.found ? problem.code : IssueCode::ring_too_few_points,
          "The relation's rings do not make a polygon; its closed ways were used one by one.", problem.at);
    add_closed_ways();
  }

  std::size_t add_area(const osmium::Area& area) {
    std::size_t count = 0;
    for (const osmium::OuterRing& outer : area.outer_rings()) {
      RawFeature feature{theme_, relation_id_, tags_, {}, {}, false};
      feature.lines.push_back(opened(located(outer)));
      for (const osmium::InnerRing& inner : area.inner_rings(outer)) feature.lines.push_back(opened(located(inner)));
      map_.features.push_back(std::move(feature));
      ++count;
    }
    return count;
  }

  static std::vector<LatLon> opened(std::vector<LatLon> ring) {
    if (!ring.empty()) ring.pop_back();
    return ring;
  }

  void read_incomplete() {
    issue(IssueCode::incomplete_relation, "Some members are missing; its closed ways were used, one by one.",
          osmium::Location{});
    add_closed_ways();
  }

  /// Holes are those of the first closed outer way only if it is the only one: else nobody knows whose they are.
  void add_closed_ways() {
    std::vector<RawFeature> outers;
    std::vector<std::vector<LatLon>> holes;
    for (const Member& member : members_) {
      const osmium::Way& way = *member.way;
      if (!is_whole(way.nodes()) || way.nodes().size() < 4 || !way.is_closed()) continue;
      if (member.is_inner()) {
        holes.push_back(opened(located(way.nodes())));
      } else {
        outers.push_back({theme_, relation_id_, tags_, {opened(located(way.nodes()))}, {}, false});
      }
    }
    if (outers.size() == 1) outers[0].lines.insert(outers[0].lines.end(), holes.begin(), holes.end());
    if (!outers.empty()) mark_replaced_ways();
    for (RawFeature& outer : outers) map_.features.push_back(std::move(outer));
  }

  RawMap& map_;
  FeatureCollector& ways_;
  std::vector<bool> gone_;
  std::string relation_id_;
  Tags tags_;
  Theme theme_ = Theme::building;
  std::vector<Member> members_;
};

}  // namespace

bool is_osm_file(const std::filesystem::path& path) {
  const std::string name = lower_case(path.filename().string());
  for (const char* ending : {".osm", ".pbf", ".osm.gz", ".osm.bz2", ".o5m", ".opl", ".osm.opl"})
    if (name.ends_with(ending)) return true;
  return false;
}

void read_osm(const std::filesystem::path& path, RawMap& map) try {
  const osmium::io::File file{path.string()};
  RelationCollector relations;
  {
    osmium::io::Reader reader{file, osmium::osm_entity_bits::relation};
    osmium::apply(reader, relations);
    reader.close();
  }
  LocationIndex index;
  LocationHandler locations{index};
  locations.ignore_errors();
  FeatureCollector features{map, relations.member_ways};
  osmium::io::Reader reader{file, osmium::osm_entity_bits::node | osmium::osm_entity_bits::way};
  const bool is_invented = reader.header().get("generator") == kTownGenerator;
  osmium::apply(reader, locations, features);
  reader.close();
  if (features.objects_seen == 0)
    throw CityError(path.string() + ": expected OSM data, found no node and no way in it", 4);
  features.find_openings();
  RelationReader polygons{map, features};
  for (const osmium::Relation& relation : relations.kept.select<osmium::Relation>()) polygons.read(relation);
  polygons.drop_replaced_ways();
  map.licences.push_back(is_invented ? kTownLicence : kOsmLicence);
} catch (const CityError&) {
  throw;
} catch (const std::exception& error) {
  throw CityError(path.string() + ": cannot be read as OSM data: " + error.what(), 4);
}

}  // namespace vicus
