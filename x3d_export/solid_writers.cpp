#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "x3d_export/house_shell.hpp"
#include "x3d_export/text.hpp"

namespace vicus {
namespace {

using Json = nlohmann::json;
using IndexRing = std::vector<std::uint32_t>;

std::int64_t cross(PlanPoint a, PlanPoint b, PlanPoint c) {
  return (std::int64_t{b.x} - a.x) * (std::int64_t{c.y} - a.y) - (std::int64_t{b.y} - a.y) * (std::int64_t{c.x} - a.x);
}
int sign(std::int64_t v) { return (v > 0) - (v < 0); }

/// Do ab and cd share a point that is no common end?
bool cuts(PlanPoint a, PlanPoint b, PlanPoint c, PlanPoint d) {
  if (a == c || a == d || b == c || b == d) return false;
  return sign(cross(a, b, c)) * sign(cross(a, b, d)) <= 0 && sign(cross(c, d, a)) * sign(cross(c, d, b)) <= 0;
}

/// A floor with holes as one ring: cut open along a line to each hole that crosses no edge; the shortest there is.
IndexRing opened(const HouseShell& shell, const ShellFace& floor) {
  IndexRing ring = floor.rings.front();
  const auto at = [&](std::uint32_t i) { return shell.points[i].at; };
  std::vector<IndexRing> holes(floor.rings.begin() + 1, floor.rings.end());
  while (!holes.empty()) {
    const auto is_free = [&](PlanPoint a, PlanPoint b) {
      const auto crosses = [&](const IndexRing& r) {
        for (std::size_t i = 0; i < r.size(); ++i)
          if (cuts(a, b, at(r[i]), at(r[(i + 1) % r.size()]))) return true;
        return false;
      };
      return !crosses(ring) && std::none_of(holes.begin(), holes.end(), crosses);
    };
    struct Bridge {
      double length2 = -1;
      std::size_t hole = 0, from = 0, to = 0;
    } best;
    for (std::size_t h = 0; h < holes.size(); ++h)
      for (std::size_t k = 0; k < holes[h].size(); ++k)
        for (std::size_t i = 0; i < ring.size(); ++i) {
          const PlanPoint a = at(ring[i]), b = at(holes[h][k]);
          const double dx = a.x - b.x, dy = a.y - b.y, length2 = dx * dx + dy * dy;
          if ((best.length2 >= 0 && length2 >= best.length2) || !is_free(a, b)) continue;
          best = {length2, h, i, k};
        }
    IndexRing& hole = holes[best.hole];
    std::rotate(hole.begin(), hole.begin() + static_cast<std::ptrdiff_t>(best.to), hole.end());
    hole.push_back(hole.front());
    hole.push_back(ring[best.from]);
    ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(best.from) + 1, hole.begin(), hole.end());
    holes.erase(holes.begin() + static_cast<std::ptrdiff_t>(best.hole));
  }
  return ring;
}

/// The faces of a shell as single rings.
std::vector<IndexRing> single_rings(const Building& house, const HouseShell& shell) {
  std::vector<IndexRing> out;
  const std::size_t first_facet = shell.faces.size() - house.roof.facets.size();
  for (std::size_t i = 0; i < shell.faces.size(); ++i) {
    const ShellFace& face = shell.faces[i];
    if (face.rings.size() == 1) {
      out.push_back(face.rings.front());
    } else if (i < first_facet) {
      out.push_back(opened(shell, face));
    } else {
      const RoofFacet& facet = house.roof.facets[i - first_facet];
      std::map<RoofPoint, std::uint32_t> numbers;
      for (std::uint32_t p = 0; p < shell.points.size(); ++p) numbers.emplace(shell.points[p], p);
      for (std::size_t t = 0; t + 2 < facet.triangles.size(); t += 3) {
        IndexRing triangle;
        for (std::size_t k = 0; k < 3; ++k)
          triangle.push_back(numbers.at(house.roof.points.at(facet.triangles[t + k])));
        out.push_back(std::move(triangle));
      }
    }
  }
  return out;
}

std::int32_t ground_steps(const Building& house) {
  return static_cast<std::int32_t>(std::lround(house.ground_m * kRoofStepsPerMetre));
}

std::string title_of(const City& city) {
  const auto name = city.meta.find("name");
  std::string origin;
  append_numbers(origin, {city.origin.lat_deg, city.origin.lon_deg}, 6, 2);
  return clean_text((name == city.meta.end() ? std::string("City") : name->second) +
                    ", metres east and north of latitude and longitude " + origin);
}

const char* surface_of(ShellPart part) {
  constexpr const char* kNames[] = {"GroundSurface", "WallSurface", "RoofSurface"};
  return kNames[static_cast<int>(part)];
}

Json solid_of(const HouseShell& shell, std::uint32_t first) {
  Json boundaries = Json::array(), values = Json::array();
  for (const ShellFace& face : shell.faces) {
    Json rings = Json::array();
    for (const auto& ring : face.rings) {
      Json out = Json::array();
      for (const std::uint32_t i : ring) out.push_back(first + i);
      rings.push_back(std::move(out));
    }
    boundaries.push_back(std::move(rings));
    values.push_back(static_cast<int>(face.part));
  }
  Json surfaces = Json::array();
  for (const ShellPart part : {ShellPart::floor, ShellPart::wall, ShellPart::roof})
    surfaces.push_back({{"type", surface_of(part)}});
  return {{"type", "Solid"},
          {"lod", "2"},
          {"boundaries", Json::array({std::move(boundaries)})},
          {"semantics", {{"surfaces", std::move(surfaces)}, {"values", Json::array({std::move(values)})}}}};
}

}  // namespace

std::string obj_text(const City& city) {
  std::string out = "# " + title_of(city) + "\n";
  std::size_t first = 1;
  for (const Building& house : city.buildings) {
    const HouseShell shell = house_shell(house);
    out += "o " + clean_text(house.id) + "\n";
    for (const RoofPoint& p : shell.points) {
      out += "v ";
      append_numbers(out, {metres(p.at.x), metres(p.at.y), (p.up + ground_steps(house)) / kRoofStepsPerMetre}, 4, 3);
      out += '\n';
    }
    for (const auto& ring : single_rings(house, shell)) {
      out += 'f';
      for (const std::uint32_t i : ring) out += " " + std::to_string(first + i);
      out += '\n';
    }
    first += shell.points.size();
  }
  return out;
}

std::string cityjson_text(const City& city) {
  Json objects = Json::object(), vertices = Json::array();
  for (const Building& house : city.buildings) {
    const HouseShell shell = house_shell(house);
    const auto first = static_cast<std::uint32_t>(vertices.size());
    for (const RoofPoint& p : shell.points) vertices.push_back({p.at.x, p.at.y, p.up + ground_steps(house)});
    objects[house.id] = {{"type", "Building"},
                         {"attributes",
                          {{"source_id", clean_text(house.source_id)},
                           {"measuredHeight", house.height_m},
                           {"roofType", house.roof_shape},
                           {"roof_source", name_of(house.roof_source)},
                           {"height_source", name_of(house.height_source)}}},
                         {"geometry", Json::array({solid_of(shell, first)})}};
  }
  const double plan = 1 / kMmPerMetre;
  const Json out = {{"type", "CityJSON"},
                    {"version", "2.0"},
                    {"transform", {{"scale", {plan, plan, 1 / kRoofStepsPerMetre}}, {"translate", {0, 0, 0}}}},
                    {"metadata", {{"title", title_of(city)}}},
                    {"CityObjects", std::move(objects)},
                    {"vertices", std::move(vertices)}};
  return out.dump() + "\n";
}

}  // namespace vicus
