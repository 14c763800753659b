#include "sectorgen/town/osm_map.hpp"

#include <algorithm>
#include <charconv>

namespace vicus::town {

namespace {

constexpr double kMetresPerDegree = 111'194.92664455873;  // sphere of 6371 km: a town needs no ellipsoid
constexpr std::int64_t kStepsPerDegree = 10'000'000;

void append(std::string& out, std::int64_t value) {
  char text[24];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  out.append(text, end);
}

void append_degrees(std::string& out, std::int32_t steps) {
  std::int64_t value = steps;
  if (value < 0) out += '-', value = -value;
  append(out, value / kStepsPerDegree);
  out += '.';
  const std::string fraction = std::to_string(kStepsPerDegree + value % kStepsPerDegree);
  out.append(fraction, 1);
}

void append_escaped(std::string& out, const std::string& text) {
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '"')
      out += "&quot;";
    else
      out += c;
  }
}

void append_tags(std::string& out, const Tags& tags) {
  for (const auto& [key, value] : tags) {
    out += "    <tag k=\"";
    append_escaped(out, key);
    out += "\" v=\"";
    append_escaped(out, value);
    out += "\"/>\n";
  }
}

}  // namespace

OsmMap::OsmMap(double lat_deg, double lon_deg)
    : lat_deg_(lat_deg),
      lon_deg_(lon_deg),
      metres_per_lon_deg_(kMetresPerDegree * sine_of_turn(0.25 + lat_deg / 360)) {}

std::pair<std::int32_t, std::int32_t> OsmMap::place(Vec at) const {
  const auto lat = std::llround((lat_deg_ + at.y / kMetresPerDegree) * kStepsPerDegree);
  auto lon = std::llround((lon_deg_ + at.x / metres_per_lon_deg_) * kStepsPerDegree);
  if (lon > 180 * kStepsPerDegree) lon -= 360 * kStepsPerDegree;
  if (lon < -180 * kStepsPerDegree) lon += 360 * kStepsPerDegree;
  return {static_cast<std::int32_t>(lat), static_cast<std::int32_t>(lon)};
}

NodeId OsmMap::node(Vec at) {
  const auto [lat, lon] = place(at);
  const auto key = static_cast<std::uint64_t>(static_cast<std::uint32_t>(lat)) << 32 | static_cast<std::uint32_t>(lon);
  const auto [found, is_new] = at_.try_emplace(key, static_cast<NodeId>(nodes_.size() + 1));
  if (is_new) nodes_.push_back({lat, lon, 0});
  return found->second;
}

NodeId OsmMap::separate_node(Vec at, int steps_east) {
  auto [lat, lon] = place(at);
  nodes_.push_back({lat, lon + steps_east, 0});
  return static_cast<NodeId>(nodes_.size());
}

NodeId OsmMap::point(Vec at, Tags tags) {
  const NodeId id = separate_node(at);
  tag_node(id, std::move(tags));
  return id;
}

void OsmMap::tag_node(NodeId id, Tags tags) {
  tags_.push_back(std::move(tags));
  nodes_[id - 1].tags = static_cast<std::uint32_t>(tags_.size() - 1);
}

std::uint32_t OsmMap::way(std::vector<NodeId> nodes, Tags tags) {
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  ways_.push_back({std::move(nodes), std::move(tags)});
  return static_cast<std::uint32_t>(ways_.size());
}

std::uint32_t OsmMap::closed_way(std::vector<NodeId> nodes, Tags tags) {
  nodes.push_back(nodes.front());
  return way(std::move(nodes), std::move(tags));
}

void OsmMap::relation(std::vector<OsmMember> members, Tags tags) {
  relations_.push_back({std::move(members), std::move(tags)});
}

std::vector<NodeId> OsmMap::nodes_of(const Polyline& line) {
  std::vector<NodeId> out;
  out.reserve(line.size() + 1);
  for (const Vec p : line) out.push_back(node(p));
  return out;
}

std::string OsmMap::xml() const {
  std::string out;
  out.reserve(nodes_.size() * 64 + ways_.size() * 500 + 1000);
  out += "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<osm version=\"0.6\" generator=\"vicus town\">\n";
  std::int64_t id = 0;
  for (const OsmNode& n : nodes_) {
    out += "  <node id=\"";
    append(out, ++id);
    out += "\" version=\"1\" lat=\"";
    append_degrees(out, n.lat);
    out += "\" lon=\"";
    append_degrees(out, n.lon);
    if (n.tags == 0) {
      out += "\"/>\n";
      continue;
    }
    out += "\">\n";
    append_tags(out, tags_[n.tags]);
    out += "  </node>\n";
  }
  id = 0;
  for (const OsmWay& w : ways_) {
    out += "  <way id=\"";
    append(out, ++id);
    out += "\" version=\"1\">\n";
    for (const NodeId ref : w.nodes) {
      out += "    <nd ref=\"";
      append(out, ref);
      out += "\"/>\n";
    }
    append_tags(out, w.tags);
    out += "  </way>\n";
  }
  id = 0;
  for (const OsmRelation& r : relations_) {
    out += "  <relation id=\"";
    append(out, ++id);
    out += "\" version=\"1\">\n";
    for (const OsmMember& m : r.members) {
      out += m.kind == 'w' ? "    <member type=\"way\" ref=\"" : "    <member type=\"node\" ref=\"";
      append(out, m.ref);
      out += "\" role=\"";
      out += m.role;
      out += "\"/>\n";
    }
    append_tags(out, r.tags);
    out += "  </relation>\n";
  }
  return out += "</osm>\n";
}

}  // namespace vicus::town
