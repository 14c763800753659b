#pragma once
#include <expat.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

/// OSM XML as a plain reader sees it; shares nothing with the generator.
namespace town_test {

using TagMap = std::map<std::string, std::string>;
struct Place {
  std::int64_t x = 0, y = 0;  ///< 1e-7 degrees east and north; longitudes continue beyond 180
  friend bool operator==(Place, Place) = default;
};
struct Node {
  Place at;
  TagMap tags;
};
struct Way {
  std::vector<std::int64_t> refs;
  TagMap tags;
};
struct Member {
  std::string type, role;
  std::int64_t ref = 0;
};
struct Relation {
  std::vector<Member> members;
  TagMap tags;
};
struct ReadTown {
  std::map<std::int64_t, Node> nodes;
  std::map<std::int64_t, Way> ways;
  std::map<std::int64_t, Relation> relations;
  TagMap* open = nullptr;
  Way* way = nullptr;
  Relation* relation = nullptr;

  const std::string& tag(const TagMap& tags, const std::string& key) const {
    static const std::string none;
    const auto it = tags.find(key);
    return it == tags.end() ? none : it->second;
  }
  std::size_t count(const std::string& key, const std::string& value = "") const {
    std::size_t n = 0;
    const auto add = [&](const TagMap& tags) {
      const auto it = tags.find(key);
      n += it != tags.end() && (value.empty() || it->second == value);
    };
    for (const auto& [id, x] : nodes) add(x.tags);
    for (const auto& [id, x] : ways) add(x.tags);
    for (const auto& [id, x] : relations) add(x.tags);
    return n;
  }
};

inline void on_start(void* user, const XML_Char* name, const XML_Char** attributes) {
  auto& town = *static_cast<ReadTown*>(user);
  TagMap a;
  for (; *attributes; attributes += 2) a[attributes[0]] = attributes[1];
  const std::string element = name;
  if (element == "node") {
    Node& n = town.nodes[std::stoll(a.at("id"))];
    n.at = {std::llround(std::stod(a.at("lon")) * 1e7), std::llround(std::stod(a.at("lat")) * 1e7)};
    if (std::abs(n.at.x) > 1'800'000'000 || std::abs(n.at.y) > 900'000'000)
      throw std::runtime_error("no place on earth");
    town.open = &n.tags;
  } else if (element == "way") {
    town.way = &town.ways[std::stoll(a.at("id"))];
    town.open = &town.way->tags;
  } else if (element == "relation") {
    town.relation = &town.relations[std::stoll(a.at("id"))];
    town.open = &town.relation->tags;
  } else if (element == "nd") {
    town.way->refs.push_back(std::stoll(a.at("ref")));
  } else if (element == "member") {
    town.relation->members.push_back({a.at("type"), a.at("role"), std::stoll(a.at("ref"))});
  } else if (element == "tag") {
    if (!town.open->emplace(a.at("k"), a.at("v")).second) throw std::runtime_error("key twice: " + a.at("k"));
  } else if (element != "osm") {
    throw std::runtime_error("unknown element " + element);
  }
}

/// Throws on anything that is not well-formed.
inline ReadTown read_town(const std::string& xml) {
  ReadTown town;
  XML_Parser parser = XML_ParserCreate(nullptr);
  XML_SetUserData(parser, &town);
  XML_SetStartElementHandler(parser, on_start);
  const bool is_read = XML_Parse(parser, xml.data(), static_cast<int>(xml.size()), 1) == XML_STATUS_OK;
  const std::string error = is_read ? "" : XML_ErrorString(XML_GetErrorCode(parser));
  XML_ParserFree(parser);
  if (!is_read) throw std::runtime_error(error);
  bool has_east = false, has_west = false;
  for (const auto& [id, n] : town.nodes) {
    has_east = has_east || n.at.x > 1'700'000'000;
    has_west = has_west || n.at.x < -1'700'000'000;
  }
  if (has_east && has_west)
    for (auto& [id, n] : town.nodes)
      if (n.at.x < 0) n.at.x += 3'600'000'000;
  return town;
}

using Outline = std::vector<Place>;

struct Built {
  std::string what;
  Outline outer;
  Outline inner;  ///< at most one hole
};

inline Outline outline_of(const ReadTown& town, const Way& way) {
  Outline ring;
  for (std::size_t i = 0; i + 1 < way.refs.size(); ++i) ring.push_back(town.nodes.at(way.refs[i]).at);
  return ring;
}

/// Every building=*, not its parts.
inline std::vector<Built> buildings_of(const ReadTown& town) {
  std::vector<Built> all;
  for (const auto& [id, way] : town.ways)
    if (way.tags.count("building")) all.push_back({"way " + std::to_string(id), outline_of(town, way), {}});
  for (const auto& [id, relation] : town.relations) {
    if (!relation.tags.count("building")) continue;
    Built b{"relation " + std::to_string(id), {}, {}};
    for (const Member& m : relation.members)
      (m.role == "outer" ? b.outer : b.inner) = outline_of(town, town.ways.at(m.ref));
    all.push_back(b);
  }
  return all;
}

inline int side(Place a, Place b, Place c) {
  const std::int64_t d = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  return d > 0 ? 1 : d < 0 ? -1 : 0;
}
inline bool cross_properly(Place a, Place b, Place c, Place d) {
  return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}
inline bool is_on(Place p, Place a, Place b) {
  return side(a, b, p) == 0 && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
         p.y <= std::max(a.y, b.y);
}
/// 1 inside, 0 on the ring, -1 outside.
inline int where(const Outline& ring, Place p) {
  bool is_inside = false;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const Place a = ring[j], b = ring[i];
    if (is_on(p, a, b)) return 0;
    if ((a.y > p.y) != (b.y > p.y) && (side(a, b, p) > 0) == (b.y > a.y)) is_inside = !is_inside;
  }
  return is_inside ? 1 : -1;
}
inline bool is_inside(const Built& b, Place p) {
  return where(b.outer, p) == 1 && (b.inner.empty() || where(b.inner, p) == -1);
}

/// No edge meets another but its neighbours, and those in one point only.
inline bool is_simple(const Outline& ring) {
  const std::size_t n = ring.size();
  if (n < 3) return false;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) {
      const Place a = ring[i], b = ring[(i + 1) % n], c = ring[j], d = ring[(j + 1) % n];
      if (a == c || cross_properly(a, b, c, d)) return false;
      if (j != i + 1 && (is_on(c, a, b) || is_on(a, c, d)) && !(c == b) && !(a == d)) return false;
      if (j == i + 1 && is_on(d, a, b) && !(d == a)) return false;
    }
  return true;
}

}  // namespace town_test
