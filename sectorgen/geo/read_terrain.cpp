#include "sectorgen/geo/read_terrain.hpp"

#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <memory>

#include "sectorgen/geo/quiet_gdal.hpp"

namespace vicus {
namespace {

constexpr double kLowest_m = -500, kHighest_m = 9000;  // of the earth's land: what is outside is no height
constexpr std::size_t kMostPixels = 40'000'000;        // of a window in memory: 160 MB
constexpr double kNoHeight = std::numeric_limits<double>::quiet_NaN();

/// Positions in pixels of the raster, counted from its corner.
struct Pixels {
  std::vector<double> x, y;  ///< not-a-number where the coordinate system does not reach
};

class Raster {
 public:
  explicit Raster(const std::filesystem::path& path) : path_(path) {
    dataset_.reset(GDALDataset::Open(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY));
    if (!dataset_ || dataset_->GetRasterCount() < 1) {
      const std::string reason = CPLGetLastErrorMsg();
      fail("expected a raster with heights (GeoTIFF, ...)" + (reason.empty() ? "" : ": " + reason));
    }
    double transform[6];
    const OGRSpatialReference* declared = dataset_->GetSpatialRef();
    if (!declared || (!declared->IsProjected() && !declared->IsGeographic()))
      fail("it has no coordinate system on the earth; give it one (gdal_edit.py -a_srs EPSG:...)");
    if (dataset_->GetGeoTransform(transform) != CE_None || !GDALInvGeoTransform(transform, to_pixels_))
      fail("it does not say where on the earth its pixels are; give it a geotransform (gdal_edit.py -a_ullr ...)");
    OGRSpatialReference wgs84, source(*declared);
    wgs84.SetWellKnownGeogCS("WGS84");
    for (auto* system : {&wgs84, &source}) system->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    to_source_.reset(OGRCreateCoordinateTransformation(&wgs84, &source));
    if (!to_source_) fail("its coordinate system cannot be used");
    read_scale();
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw CityError("cannot take heights from " + path_.string() + ": " + what, 4);
  }

  int width() const { return dataset_->GetRasterXSize(); }
  int height() const { return dataset_->GetRasterYSize(); }

  /// x: longitudes, y: latitudes.
  Pixels pixels_of(Pixels degrees) const {
    std::vector<int> is_done(degrees.x.size());
    to_source_->Transform(static_cast<int>(degrees.x.size()), degrees.x.data(), degrees.y.data(), nullptr, nullptr,
                          is_done.data());
    for (std::size_t i = 0; i < is_done.size(); ++i) {
      const double x = degrees.x[i], y = degrees.y[i];
      degrees.x[i] = is_done[i] ? to_pixels_[0] + x * to_pixels_[1] + y * to_pixels_[2] : kNoHeight;
      degrees.y[i] = is_done[i] ? to_pixels_[3] + x * to_pixels_[4] + y * to_pixels_[5] : kNoHeight;
    }
    return degrees;
  }

  /// Pixels [left, right) x [top, bottom), shrunk to at most kMostPixels.
  void read(int left, int top, int right, int bottom) {
    left_ = left;
    top_ = top;
    const double wide = right - left, high = bottom - top;
    shrink_ = std::max(1.0, std::sqrt(wide * high / static_cast<double>(kMostPixels)));
    columns_ = std::max(1, static_cast<int>(wide / shrink_));
    rows_ = std::max(1, static_cast<int>(high / shrink_));
    shrink_x_ = wide / columns_;
    shrink_y_ = high / rows_;
    values_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
    GDALRasterIOExtraArg extra;
    INIT_RASTERIO_EXTRA_ARG(extra);
    extra.eResampleAlg = shrink_ > 1 ? GRIORA_Average : GRIORA_NearestNeighbour;
    if (dataset_->GetRasterBand(1)->RasterIO(GF_Read, left, top, right - left, bottom - top, values_.data(), columns_,
                                             rows_, GDT_Float32, 0, 0, &extra) != CE_None)
      fail(std::string("it cannot be read: ") + CPLGetLastErrorMsg());
  }

  /// Bilinear; not-a-number: a hole, or outside of what was read.
  double height_at(double px, double py) const {
    if (!(px >= 0 && py >= 0 && px <= width() && py <= height())) return kNoHeight;
    const double x = (px - left_) / shrink_x_ - 0.5, y = (py - top_) / shrink_y_ - 0.5;
    const double column = std::floor(x), row = std::floor(y);
    double sum = 0, weight = 0;
    for (const int dx : {0, 1})
      for (const int dy : {0, 1}) {
        const double share = (dx ? x - column : column + 1 - x) * (dy ? y - row : row + 1 - y);
        const double value = value_at(static_cast<int>(column) + dx, static_cast<int>(row) + dy);
        if (std::isnan(value)) continue;
        sum += share * value;
        weight += share;
      }
    return weight >= 0.5 ? sum / weight : kNoHeight;
  }

 private:
  void read_scale() {
    GDALRasterBand& band = *dataset_->GetRasterBand(1);
    int is_given = 0;
    no_data_ = static_cast<float>(band.GetNoDataValue(&is_given));
    if (!is_given) no_data_ = std::numeric_limits<float>::quiet_NaN();
    std::string unit = band.GetUnitType();
    // Where only the vertical system says so; not every writer repeats it.
    if (const OGRSpatialReference* system = dataset_->GetSpatialRef(); unit.empty() && system->IsVertical()) {
      const char* name = nullptr;
      if (system->GetTargetLinearUnits("VERT_CS", &name) != 1 && name) unit = name;
    }
    const double unit_m = unit == "ft" || unit == "foot" || unit == "feet"                ? 0.3048
                          : unit == "US survey foot" || unit == "us-ft" || unit == "ftUS" ? 1200.0 / 3937
                                                                                          : 1;
    scale_ = band.GetScale() * unit_m;
    offset_ = band.GetOffset() * unit_m;
  }

  double value_at(int column, int row) const {
    column = std::clamp(column, 0, columns_ - 1);
    row = std::clamp(row, 0, rows_ - 1);
    const float raw =
        values_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column)];
    if (raw == no_data_ || !std::isfinite(raw)) return kNoHeight;
    const double height = offset_ + scale_ * raw;
    return height >= kLowest_m && height <= kHighest_m ? height : kNoHeight;
  }

  std::filesystem::path path_;
  GDALDatasetUniquePtr dataset_;
  std::unique_ptr<OGRCoordinateTransformation> to_source_;
  double to_pixels_[6] = {};
  float no_data_ = 0;
  double scale_ = 1, offset_ = 0;
  int left_ = 0, top_ = 0, columns_ = 0, rows_ = 0;
  double shrink_ = 1, shrink_x_ = 1, shrink_y_ = 1;
  std::vector<float> values_;
};

/// The grid without heights: it covers the box.
Terrain grid_over(const PlanBox& box, const TerrainOptions& options, bool& is_coarsened) {
  Terrain t;
  t.corner = box.min;
  t.step_mm = options.step_mm;
  const auto nodes = [&](std::int64_t low, std::int64_t high) {
    return static_cast<std::uint32_t>((high - low + t.step_mm - 1) / t.step_mm + 1);
  };
  for (;; t.step_mm = (t.step_mm / 1000 + 1) * 1000, is_coarsened = true) {
    t.columns = nodes(box.min.x, box.max.x);
    t.rows = nodes(box.min.y, box.max.y);
    if (std::size_t{t.columns} * t.rows <= options.most_nodes) return t;
  }
}

PlanPoint node_at(const Terrain& t, std::size_t i) {
  return {t.corner.x + static_cast<std::int32_t>(i % t.columns) * t.step_mm,
          t.corner.y + static_cast<std::int32_t>(i / t.columns) * t.step_mm};
}

Pixels degrees_of(const Terrain& grid, const PlanFrame& frame) {
  Pixels degrees;
  const std::size_t count = std::size_t{grid.columns} * grid.rows;
  for (auto* list : {&degrees.x, &degrees.y}) list->reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const LatLon p = frame.latlon_from_plan(node_at(grid, i));
    degrees.x.push_back(p.lon_deg);
    degrees.y.push_back(p.lat_deg);
  }
  return degrees;
}

/// Reads the part of the raster under the grid.
void read_under(Raster& raster, const Pixels& at) {
  double left = raster.width(), top = raster.height(), right = 0, bottom = 0;
  for (std::size_t i = 0; i < at.x.size(); ++i)
    if (at.x[i] >= 0 && at.y[i] >= 0 && at.x[i] <= raster.width() && at.y[i] <= raster.height()) {
      left = std::min(left, at.x[i]);
      right = std::max(right, at.x[i]);
      top = std::min(top, at.y[i]);
      bottom = std::max(bottom, at.y[i]);
    }
  if (left > right) raster.fail("it does not cover any of the city; is its coordinate system the right one?");
  const auto low = [](double v) { return std::max(0, static_cast<int>(v) - 1); };
  raster.read(low(left), low(top), std::min(raster.width(), static_cast<int>(right) + 2),
              std::min(raster.height(), static_cast<int>(bottom) + 2));
}

/// Gives each hole the mean of its neighbours that have a height, those next to heights first. The number of holes.
std::size_t fill_holes(const Terrain& grid, std::vector<double>& heights) {
  const auto visit_neighbours = [&](std::size_t i, const auto& visit) {
    const std::size_t column = i % grid.columns, row = i / grid.columns;
    if (column > 0) visit(i - 1);
    if (column + 1 < grid.columns) visit(i + 1);
    if (row > 0) visit(i - grid.columns);
    if (row + 1 < grid.rows) visit(i + grid.columns);
  };
  std::vector<std::size_t> ring;
  for (std::size_t i = 0; i < heights.size(); ++i)
    if (std::isnan(heights[i])) ring.push_back(i);
  const std::size_t holes = ring.size();
  if (holes == heights.size()) return holes;
  std::vector<std::pair<std::size_t, double>> filled;
  while (!ring.empty()) {
    std::vector<std::size_t> left;
    filled.clear();
    for (const auto i : ring) {
      double sum = 0;
      int count = 0;
      visit_neighbours(i, [&](std::size_t other) {
        if (!std::isnan(heights[other])) sum += heights[other], ++count;
      });
      if (count > 0)
        filled.emplace_back(i, sum / count);
      else
        left.push_back(i);
    }
    for (const auto& [i, height] : filled) heights[i] = height;
    ring = std::move(left);
  }
  return holes;
}

}  // namespace

ReadTerrain read_terrain(const std::filesystem::path& path, const PlanFrame& frame, const PlanBox& box,
                         const TerrainOptions& options, std::vector<Issue>& issues) {
  assert(!box.is_empty() && options.step_mm > 0);
  const QuietGdal quiet;
  Raster raster(path);
  ReadTerrain read;
  Terrain& grid = read.terrain = grid_over(box, options, read.is_coarsened);
  const Pixels at = raster.pixels_of(degrees_of(grid, frame));
  read_under(raster, at);
  std::vector<double> heights(at.x.size());
  for (std::size_t i = 0; i < heights.size(); ++i) heights[i] = raster.height_at(at.x[i], at.y[i]);
  const auto first_hole = std::find_if(heights.begin(), heights.end(), [](double h) { return std::isnan(h); });
  const auto hole =
      first_hole == heights.end() ? PlanPoint{} : node_at(grid, static_cast<std::size_t>(first_hole - heights.begin()));
  read.filled = fill_holes(grid, heights);
  if (read.filled == heights.size()) raster.fail("it has no height anywhere in the city");
  if (read.filled > 0)
    issues.push_back({IssueCode::terrain_hole,
                      std::to_string(read.filled) + " of " + std::to_string(heights.size()) +
                          " nodes of the terrain have no height in the raster and took it from those around",
                      path.filename().string(), hole});
  // From the rounded height: a mean of equal heights may fall short of them in the last bit.
  const std::int32_t lowest_mm = lattice_mm(*std::min_element(heights.begin(), heights.end()));
  read.base_m = static_cast<int>(std::floor(metres(lowest_mm)));
  for (const double h : heights) grid.height_mm.push_back(lattice_mm(h - read.base_m));
  return read;
}

}  // namespace vicus
