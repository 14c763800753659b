#include "sectorgen/models/photo_facades.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "city_db/facade_layout.hpp"
#include "sectorgen/models/palette_png.hpp"
#include "sectorgen/models/rectify.hpp"
#include "sectorgen/models/window_grid.hpp"

namespace vicus {
namespace {

constexpr double kPixelsPerMetre = 26;  // twice a painted facade's: a photo has more to show
constexpr int kPhotoColours = 64;
constexpr double kLookingThere_deg = 45;  // a facade looks where the table says within so much

/// Clockwise from north; ground on the left of a -> b, so the facade looks left.
double heading_deg(const Facade& f) {
  const double east = -(static_cast<double>(f.b.y) - f.a.y), north = static_cast<double>(f.b.x) - f.a.x;
  return std::atan2(east, north) * 180 / std::numbers::pi;
}

double turn_deg(double a, double b) { return std::abs(std::remainder(a - b, 360)); }

/// The facade that the photo shows; null: there is none.
Facade* facade_of(const FacadePhoto& photo, City& city) {
  const auto house = std::find_if(city.buildings.begin(), city.buildings.end(),
                                  [&](const Building& b) { return b.id == photo.house || b.source_id == photo.house; });
  if (house == city.buildings.end()) return nullptr;
  Facade* best = nullptr;
  for (Facade& f : city.facades) {
    if (f.building_id != house->id) continue;
    if (photo.heading_deg && turn_deg(heading_deg(f), *photo.heading_deg) > kLookingThere_deg) continue;
    if (!best || length_m(f) > length_m(*best)) best = &f;
  }
  return best;
}

/// The mean of what is no opening.
Colour wall_colour(const Canvas& picture, const Facade& facade) {
  const auto openings = openings_of(facade);
  Paint sum;
  double count = 0;
  for (int row = 0; row < picture.height(); ++row)
    for (int column = 0; column < picture.width(); ++column) {
      const double x = (column + 0.5) * picture.width_m() / picture.width(),
                   z = (picture.height() - row - 0.5) * picture.height_m() / picture.height();
      if (std::any_of(openings.begin(), openings.end(),
                      [&](const Opening& o) { return x > o.x0 && x < o.x1 && z > o.z0 && z < o.z1; }))
        continue;
      const Paint p = picture.at(column, row);
      sum = {sum.r + p.r, sum.g + p.g, sum.b + p.b};
      ++count;
    }
  const auto byte = [&](double v) { return static_cast<std::uint8_t>(std::lround(255 * v / std::max(1.0, count))); };
  return {byte(sum.r), byte(sum.g), byte(sum.b)};
}

}  // namespace

int photo_side(double side_m) { return texture_side(kPixelsPerMetre * side_m); }

void hang_picture(const Canvas& picture, std::optional<int> bays, std::optional<int> floors, Facade& facade,
                  Building& house, City& city) {
  if (facade.openings.empty()) {
    // One picture, one pattern: it may not be tiled.
    const auto found_bays = find_bays(picture), found_floors = find_floors(picture);
    facade.bays = std::clamp(bays         ? *bays
                             : found_bays ? found_bays->count
                                          : facade.bays * facade.repeats,
                             1, kMostBays);
    facade.floors = std::clamp(floors ? *floors : found_floors ? found_floors->count : facade.floors, 1, kMostFloors);
    facade.repeats = 1;
    if (facade.door_bay >= facade.bays) facade.door_bay = facade.bays / 2;
  }
  house.wall_colour = wall_colour(picture, facade);
  Texture texture = palette_texture(picture, kPhotoColours);
  facade.texture = texture.id;
  city.textures.push_back(std::move(texture));
}

void hang_photos(const std::vector<FacadePhoto>& photos, City& city) {
  for (const FacadePhoto& photo : photos) {
    Facade* facade = facade_of(photo, city);
    if (!facade) {
      city.issues.push_back(
          {IssueCode::unknown_place,
           photo.house + " is no house of this city that shows a facade there: its photo hangs nowhere.",
           photo.source_id, PlanPoint{}});
      continue;
    }
    const double width_m = length_m(*facade), height_m = facade->top_m - facade->bottom_m;
    const auto house = std::find_if(city.buildings.begin(), city.buildings.end(),
                                    [&](const Building& b) { return b.id == facade->building_id; });
    hang_picture(rectified(photo.file, photo.corners, photo_side(width_m), photo_side(height_m), width_m, height_m),
                 photo.bays, photo.floors, *facade, *house, city);
  }
}

}  // namespace vicus
