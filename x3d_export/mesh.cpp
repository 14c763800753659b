#include "x3d_export/mesh.hpp"

#include <cassert>
#include <cmath>
#include <numbers>

#include "x3d_export/shared_points.hpp"

namespace vicus {
namespace {

double unit(std::uint8_t channel) { return channel / 255.0; }
std::vector<double> values_of(Colour c) { return {unit(c.r), unit(c.g), unit(c.b)}; }

Node appearance_of(Shading shading, Colour colour, bool is_coloured_by_face) {
  Node material("Material");
  // Browsers differ in what ambient light does with colours by face; three lights of the root world do without it.
  material.set("ambientIntensity", 0.0);
  if (shading == Shading::backdrop)
    material.set("diffuseColor", std::vector<double>{0, 0, 0}).set("emissiveColor", values_of(colour));
  else
    material.set("diffuseColor", is_coloured_by_face ? std::vector<double>{1, 1, 1} : values_of(colour));
  Node appearance("Appearance");
  return appearance.add("material", material);
}

}  // namespace

std::string texture_url(const std::string& id) { return "../textures/" + id + ".png"; }

void FaceList::add_wall(PlanPoint a, PlanPoint b, double bottom_m, double top_m, Colour colour, int bays, int floors) {
  const std::int32_t low = up(bottom_m), high = up(top_m);
  if (a == b || low >= high) return;
  // Seen from the left of a -> b, b is the left end:  b1--a1
  //                                                   b0--a0
  faces_.push_back({{x3d_from_plan(b, low, origin_), x3d_from_plan(a, low, origin_), x3d_from_plan(a, high, origin_),
                     x3d_from_plan(b, high, origin_)},
                    4,
                    colour,
                    static_cast<std::uint8_t>(bays),
                    static_cast<std::uint8_t>(floors)});
}

void FaceList::add_floor(const Polygon& polygon, const Triangles& triangles, double up_m, Colour colour,
                         bool from_below) {
  std::vector<PlanPoint> points = polygon.outer;
  for (const auto& hole : polygon.holes) points.insert(points.end(), hole.begin(), hole.end());
  const std::int32_t level = up(up_m);
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
    std::array<X3dPoint, 4> corners{};
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = x3d_from_plan(points.at(triangles[i + (from_below ? 2 - k : k)]), level, origin_);
    faces_.push_back({corners, 3, colour});
  }
}

void FaceList::add_block(PlanPoint middle, double width_m, double bottom_m, double top_m, Colour colour) {
  const std::int32_t r = lattice_mm(width_m / 2);
  const std::array<PlanPoint, 4> corners{{{middle.x - r, middle.y - r},
                                          {middle.x + r, middle.y - r},
                                          {middle.x + r, middle.y + r},
                                          {middle.x - r, middle.y + r}}};
  std::array<X3dPoint, 4> top{};
  for (std::size_t i = 0; i < 4; ++i) {
    add_wall(corners[(i + 1) % 4], corners[i], bottom_m, top_m, colour);
    top[i] = x3d_from_plan(corners[i], up(top_m), origin_);
  }
  faces_.push_back({top, 4, colour});
}

void FaceList::add_triangle(const RoofPoint& a, const RoofPoint& b, const RoofPoint& c, Colour colour) {
  std::array<X3dPoint, 4> corners{};
  const std::array<const RoofPoint*, 3> points{&a, &b, &c};
  for (std::size_t k = 0; k < 3; ++k)
    corners[k] = x3d_from_plan(points[k]->at, up(points[k]->up / kRoofStepsPerMetre), origin_);
  const auto side = [&](std::size_t k) {
    return std::array{std::int64_t{corners[k].x} - corners[0].x, std::int64_t{corners[k].y} - corners[0].y,
                      std::int64_t{corners[k].z} - corners[0].z};
  };
  const auto u = side(1), v = side(2);
  if (u[0] * v[1] == u[1] * v[0] && u[1] * v[2] == u[2] * v[1] && u[2] * v[0] == u[0] * v[2]) return;
  faces_.push_back({corners, 3, colour});
}

void FaceList::add_spindle(PlanPoint at, int sides, double radius_low_m, double radius_high_m, double low_m,
                           double high_m, Colour colour) {
  const auto corner = [&](int side, double radius_m, double up_m) {
    const double turn = 2 * std::numbers::pi * side / sides;
    const PlanPoint p{at.x + lattice_mm(radius_m * std::cos(turn)), at.y + lattice_mm(radius_m * std::sin(turn))};
    return x3d_from_plan(p, up(up_m), origin_);
  };
  for (int i = 0; i < sides; ++i) {
    const auto a = corner(i, radius_low_m, low_m), b = corner(i + 1, radius_low_m, low_m);
    const auto c = corner(i + 1, radius_high_m, high_m), d = corner(i, radius_high_m, high_m);
    if (radius_high_m == 0)
      faces_.push_back({{a, b, c, {}}, 3, colour});
    else if (radius_low_m == 0)
      faces_.push_back({{a, c, d, {}}, 3, colour});
    else
      faces_.push_back({{a, b, c, d}, 4, colour});
  }
}

void FaceList::add_ground(const std::vector<GroundPoint>& points, const Triangles& triangles, Colour colour) {
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
    std::array<X3dPoint, 4> corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      const GroundPoint& p = points.at(triangles[i + k]);
      corners[k] = x3d_from_plan(p.at, p.up_mm, origin_);
    }
    faces_.push_back({corners, 3, colour});
  }
}

void FaceList::add_sloped_wall(PlanPoint a, PlanPoint b, std::int32_t a_mm, std::int32_t b_mm, double low_m,
                               double high_m, Colour colour) {
  const std::int32_t low = height_mm(low_m), high = height_mm(high_m);
  if (a == b || low >= high) return;
  faces_.push_back({{x3d_from_plan(b, b_mm + low, origin_), x3d_from_plan(a, a_mm + low, origin_),
                     x3d_from_plan(a, a_mm + high, origin_), x3d_from_plan(b, b_mm + high, origin_)},
                    4,
                    colour});
}

namespace {

using Place = std::array<double, 2>;

std::vector<double> numbers_of(const std::vector<Place>& places) {
  std::vector<double> out;
  out.reserve(2 * places.size());
  for (const Place& place : places) out.insert(out.end(), place.begin(), place.end());
  return out;
}

Node with_places(Node geometry, const std::vector<Place>& places) {
  Node node("TextureCoordinate");
  node.set("point", numbers_of(places));
  return geometry.add("texCoord", std::move(node));
}

Node coordinate_of(const std::vector<X3dPoint>& points) {
  Node node("Coordinate");
  node.set("point", numbers_of(points));
  return node;
}

/// An IndexedFaceSet of corners that others have, too.
Node under_image(std::span<const TexturedFace> faces, SharedPoints& points) {
  Numbering<Place> number_of_place;
  std::vector<std::int32_t> point_index, place_index;
  for (const TexturedFace& face : faces) {
    for (std::size_t k = 0; k < 4; ++k) {
      point_index.push_back(points(face.corners[k]));
      place_index.push_back(number_of_place(face.uv[k]));
    }
    for (auto* index : {&point_index, &place_index}) index->push_back(-1);
  }
  Node geometry("IndexedFaceSet");
  geometry.set("coordIndex", std::move(point_index)).set("texCoordIndex", std::move(place_index));
  geometry.add("coord", points.coordinate());
  return with_places(std::move(geometry), number_of_place.items());
}

/// An IndexedFaceSet. One list of indices serves points and places in the image where that is less text.
Node under_image(std::span<const TexturedFace> faces) {
  Numbering<X3dPoint> number_of_point;
  Numbering<Place> number_of_place;
  Numbering<std::pair<X3dPoint, Place>> number_of_both;
  std::vector<std::int32_t> point_index, place_index, both_index;
  for (const TexturedFace& face : faces) {
    for (std::size_t k = 0; k < 4; ++k) {
      point_index.push_back(number_of_point(face.corners[k]));
      place_index.push_back(number_of_place(face.uv[k]));
      both_index.push_back(number_of_both({face.corners[k], face.uv[k]}));
    }
    for (auto* index : {&point_index, &place_index, &both_index}) index->push_back(-1);
  }
  Node geometry("IndexedFaceSet");
  constexpr std::size_t kPoint = 20, kPlace = 12, kIndex = 4;  // bytes of text
  const std::size_t both = number_of_both.items().size(), alone = number_of_point.items().size();
  if (kPoint * (both - alone) + kPlace * both > kPlace * number_of_place.items().size() + kIndex * place_index.size()) {
    geometry.set("coordIndex", std::move(point_index)).set("texCoordIndex", std::move(place_index));
    geometry.add("coord", coordinate_of(number_of_point.items()));
    return with_places(std::move(geometry), number_of_place.items());
  }
  std::vector<X3dPoint> points;
  std::vector<Place> places;
  for (const auto& [point, place] : number_of_both.items()) {
    points.push_back(point);
    places.push_back(place);
  }
  geometry.set("coordIndex", std::move(both_index)).add("coord", coordinate_of(points));
  return with_places(std::move(geometry), places);
}

}  // namespace

Node textured_shape(const std::string& image, const std::string& url, std::span<const TexturedFace> faces,
                    SharedPoints* points) {
  assert(!faces.empty());
  Node geometry = points ? under_image(faces, *points) : under_image(faces);
  Node appearance("Appearance", "IMAGE-" + image), material("Material"), texture("ImageTexture");
  material.set("ambientIntensity", 0.0).set("diffuseColor", std::vector<double>{1, 1, 1});
  appearance.add("material", material);
  appearance.add("texture", texture.set("url", std::vector<std::string>{url}));
  Node shape("Shape");
  shape.add("appearance", std::move(appearance));
  return shape.add("geometry", std::move(geometry));
}

Node shape_of(const std::string& def, Shading shading, std::span<const Face> faces, SharedPoints* points) {
  assert(!faces.empty());
  Numbering<X3dPoint> own_points;
  Numbering<Colour> number_of_colour;
  std::vector<std::int32_t> coord_index, color_index;
  const auto number_of = [&](const X3dPoint& p) { return points ? (*points)(p) : own_points(p); };
  for (const Face& face : faces) {
    for (int k = 0; k < face.count; ++k) coord_index.push_back(number_of(face.corners[static_cast<std::size_t>(k)]));
    coord_index.push_back(-1);
    color_index.push_back(number_of_colour(face.colour));
  }
  std::vector<double> colours;
  for (const auto& c : number_of_colour.items())
    for (const double v : values_of(c)) colours.push_back(v);

  const bool is_coloured_by_face = number_of_colour.items().size() > 1;
  Node geometry("IndexedFaceSet");
  if (shading == Shading::two_sided) geometry.set("solid", false);
  geometry.set("coordIndex", std::move(coord_index));
  if (is_coloured_by_face) geometry.set("colorPerVertex", false).set("colorIndex", std::move(color_index));
  geometry.add("coord", points ? points->coordinate() : coordinate_of(own_points.items()));
  Node color("Color");
  if (is_coloured_by_face) geometry.add("color", color.set("color", std::move(colours)));
  Node shape("Shape", def);
  shape.add("appearance", appearance_of(shading, faces.front().colour, is_coloured_by_face));
  return shape.add("geometry", std::move(geometry));
}

Node fading_shape(const std::string& def, std::span<const Face> faces) {
  assert(!faces.empty());
  constexpr std::int32_t kWholeBelow = 4;  // a quarter
  Numbering<X3dPoint> number_of_point;
  std::vector<std::int32_t> coord_index;
  std::vector<double> colours;
  // Black is what the lights fall on: the material shines by itself.
  const auto number = [&](const X3dPoint& p, double opacity) {
    const std::int32_t n = number_of_point(p);
    if (4 * static_cast<std::size_t>(n) == colours.size()) colours.insert(colours.end(), {0, 0, 0, opacity});
    return n;
  };
  for (const Face& face : faces) {
    assert(face.count == 4 && face.colour == faces.front().colour);
    const auto& c = face.corners;
    const auto between = [&](std::size_t low, std::size_t high) {
      X3dPoint p = c[low];
      p.y += (c[high].y - c[low].y) / kWholeBelow;
      return number(p, 1);
    };
    const std::int32_t left_foot = number(c[0], 1), right_foot = number(c[1], 1), right = between(1, 2),
                       left = between(0, 3), right_top = number(c[2], 0), left_top = number(c[3], 0);
    coord_index.insert(coord_index.end(),
                       {left_foot, right_foot, right, left, -1, left, right, right_top, left_top, -1});
  }
  Node geometry("IndexedFaceSet"), color("ColorRGBA");
  geometry.set("coordIndex", std::move(coord_index)).add("coord", coordinate_of(number_of_point.items()));
  geometry.add("color", color.set("color", std::move(colours)));
  Node shape("Shape", def);
  shape.add("appearance", appearance_of(Shading::backdrop, faces.front().colour, false));
  return shape.add("geometry", std::move(geometry));
}

}  // namespace vicus
