#include "sectorgen/models/model_photos.hpp"

#include <OpenImageIO/imagebuf.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <unordered_map>

#include "city_db/facade_layout.hpp"
#include "sectorgen/models/canvas.hpp"
#include "sectorgen/models/photo_facades.hpp"

namespace vicus {
namespace {

constexpr double kReach_m = 0.5;       // a wall so near to a facade's plane is the facade's
constexpr double kLeastCovered = 0.5;  // of a facade
constexpr double kMostPixels = 1e8;
constexpr int kSamples = 3;       // squared, of each pixel
constexpr std::size_t kKept = 4;  // images held at once: those of one house come together

using ImagePointer = std::shared_ptr<const OIIO::ImageBuf>;

struct Point {
  double x = 0, z = 0;
};

/// A wall's outline on a facade, and its image's place as a linear function of x, z and 1.
struct Patch {
  std::vector<Point> outline;
  std::array<double, 3> u{}, v{};
  ImagePointer image;
};

/// Even-odd.
bool is_inside(const std::vector<Point>& ring, double x, double z) {
  bool inside = false;
  for (std::size_t i = 0, k = ring.size() - 1; i < ring.size(); k = i++) {
    const Point &p = ring[i], &q = ring[k];
    if ((p.z > z) != (q.z > z) && x < (q.x - p.x) * (z - p.z) / (q.z - p.z) + p.x) inside = !inside;
  }
  return inside;
}

/// Least squares of value = c0 x + c1 z + c2 over the corners. Nothing: they lie in one line.
std::optional<std::array<double, 3>> linear_fit(const std::vector<Point>& points, const std::vector<double>& values) {
  const double n = static_cast<double>(points.size());
  double mx = 0, mz = 0, mv = 0, xx = 0, xz = 0, zz = 0, xv = 0, zv = 0;
  for (std::size_t i = 0; i < points.size(); ++i) mx += points[i].x / n, mz += points[i].z / n, mv += values[i] / n;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double x = points[i].x - mx, z = points[i].z - mz, v = values[i] - mv;
    xx += x * x, xz += x * z, zz += z * z, xv += x * v, zv += z * v;
  }
  const double det = xx * zz - xz * xz;
  if (!(det > 1e-6 * xx * zz) || xx <= 0 || zz <= 0) return std::nullopt;
  const double a = (xv * zz - zv * xz) / det, b = (zv * xx - xv * xz) / det;
  return std::array{a, b, mv - a * mx - b * mz};
}

class Images {
 public:
  ImagePointer at(const std::filesystem::path& file) {
    if (const auto found = held_.find(file.string()); found != held_.end()) return found->second;
    if (held_.size() >= kKept) held_.clear();
    const auto image = std::make_shared<OIIO::ImageBuf>(file.string());
    if (!image->init_spec(file.string(), 0, 0) || image->spec().width < 2 || image->spec().height < 2)
      throw CityError(file.string() + ": expected a picture: " + image->geterror(), 4);
    if (static_cast<double>(image->spec().width) * image->spec().height > kMostPixels)
      throw CityError(file.string() + ": has more than 100 million pixels; make it smaller", 4);
    if (!image->read(0, 0, true, OIIO::TypeDesc::UINT8)) throw CityError(file.string() + ": " + image->geterror(), 4);
    held_.emplace(file.string(), image);
    return image;
  }

 private:
  std::unordered_map<std::string, ImagePointer> held_;
};

std::optional<Patch> patch_on(const Facade& f, const ModelPhoto& photo) {
  const double length = length_m(f);
  const double ux = metres(f.a.x - f.b.x) / length, uy = metres(f.a.y - f.b.y) / length;
  Patch patch;
  for (const ModelPoint& p : photo.corners) {
    const double px = metres(p.at.x - f.b.x), py = metres(p.at.y - f.b.y);
    if (std::abs(py * ux - px * uy) > kReach_m) return std::nullopt;
    patch.outline.push_back({px * ux + py * uy, p.up_m - f.bottom_m});
  }
  std::vector<double> u, v;
  for (const auto& [at_u, at_v] : photo.places) u.push_back(at_u), v.push_back(at_v);
  const auto fit_u = linear_fit(patch.outline, u), fit_v = linear_fit(patch.outline, v);
  if (!fit_u || !fit_v) return std::nullopt;
  patch.u = *fit_u;
  patch.v = *fit_v;
  return patch;
}

std::optional<Paint> sample(const std::vector<Patch>& patches, double x, double z) {
  for (const Patch& patch : patches) {
    if (!is_inside(patch.outline, x, z)) continue;
    const auto at = [&](const std::array<double, 3>& c) { return c[0] * x + c[1] * z + c[2]; };
    float pixel[4] = {0, 0, 0, 0};
    patch.image->interppixel_NDC(static_cast<float>(at(patch.u)), static_cast<float>(1 - at(patch.v)), pixel,
                                 OIIO::ImageBuf::WrapPeriodic);
    if (patch.image->nchannels() < 3) pixel[1] = pixel[2] = pixel[0];
    return Paint{pixel[0], pixel[1], pixel[2]};
  }
  return std::nullopt;
}

/// No finer than the images are. Places without an image get the mean of the others. Nothing: too many are without.
std::optional<Canvas> picture_of(const Facade& f, const std::vector<Patch>& patches) {
  const double width_m = length_m(f), height_m = f.top_m - f.bottom_m;
  double along = 0, up = 0;  // pixels of the images, the finest, per metre
  for (const Patch& patch : patches) {
    const double w = patch.image->spec().width, h = patch.image->spec().height;
    along = std::max(along, std::hypot(patch.u[0] * w, patch.v[0] * h));
    up = std::max(up, std::hypot(patch.u[1] * w, patch.v[1] * h));
  }
  Canvas picture(std::min(photo_side(width_m), texture_side(along * width_m)),
                 std::min(photo_side(height_m), texture_side(up * height_m)), width_m, height_m);
  std::vector<std::pair<int, int>> bare;
  Paint mean;
  double covered = 0;
  for (int row = 0; row < picture.height(); ++row)
    for (int column = 0; column < picture.width(); ++column) {
      Paint sum;
      int count = 0;
      for (int i = 0; i < kSamples * kSamples; ++i) {
        const double x = (column + (i % kSamples + 0.5) / kSamples) * width_m / picture.width();
        const double z = (picture.height() - row - (i / kSamples + 0.5) / kSamples) * height_m / picture.height();
        if (const auto p = sample(patches, x, z); p) sum = {sum.r + p->r, sum.g + p->g, sum.b + p->b}, ++count;
      }
      if (count == 0) {
        bare.emplace_back(column, row);
        continue;
      }
      sum = sum * (1.0 / count);
      picture.set(column, row, sum);
      mean = {mean.r + sum.r, mean.g + sum.g, mean.b + sum.b};
      ++covered;
    }
  if (covered < kLeastCovered * picture.width() * picture.height()) return std::nullopt;
  for (const auto& [column, row] : bare) picture.set(column, row, mean * (1 / covered));
  return picture;
}

}  // namespace

void hang_model_photos(const std::map<std::string, HouseModel>& models, City& city) {
  std::unordered_map<std::string, std::vector<Facade*>> facades;
  for (Facade& f : city.facades) facades[f.building_id].push_back(&f);
  Images images;
  for (Building& house : city.buildings) {
    const auto model = models.find(house.source_id);
    const auto own = facades.find(house.id);
    if (model == models.end() || model->second.photos.empty() || own == facades.end()) continue;
    // The longest last: its colour is the house's.
    std::stable_sort(own->second.begin(), own->second.end(),
                     [](const Facade* a, const Facade* b) { return length_m(*a) < length_m(*b); });
    for (Facade* f : own->second) {
      std::vector<Patch> patches;
      for (const ModelPhoto& photo : model->second.photos)
        if (auto patch = patch_on(*f, photo); patch) {
          patch->image = images.at(photo.image);
          patches.push_back(std::move(*patch));
        }
      if (patches.empty()) continue;
      if (const auto picture = picture_of(*f, patches); picture)
        hang_picture(*picture, std::nullopt, std::nullopt, *f, house, city);
    }
  }
}

}  // namespace vicus
