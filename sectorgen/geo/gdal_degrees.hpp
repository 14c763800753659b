#pragma once
#include <ogr_spatialref.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "sectorgen/geo/add_feature.hpp"

/// How coordinates of a declared system become degrees, by PROJ. Included by the .cpp files that read with GDAL.
namespace vicus {

class DegreesOf {
 public:
  explicit DegreesOf(const OGRSpatialReference* declared) {
    wgs84_.SetWellKnownGeogCS("WGS84");
    wgs84_.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    if (!declared || (!declared->IsProjected() && !declared->IsGeographic())) return;
    source_ = *declared;
    source_.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    system_.is_declared = true;
    system_.name = source_.GetName() ? source_.GetName() : "unnamed";
    if (const char* code = source_.GetAuthorityCode(nullptr))
      system_.name = std::string(source_.GetAuthorityName(nullptr)) + ":" + code + ", " + system_.name;
    const char* area_name = nullptr;
    if (!source_.GetAreaOfUse(&system_.west, &system_.south, &system_.east, &system_.north, &area_name) ||
        system_.west < -180)
      system_ = CoordinateSystem{system_.name, true};
    if (!source_.IsSame(&wgs84_)) transform_.reset(OGRCreateCoordinateTransformation(&source_, &wgs84_));
    has_failed_ = !source_.IsSame(&wgs84_) && !transform_;
  }

  const CoordinateSystem& system() const { return system_; }
  bool is_unusable() const { return has_failed_; }

  /// Positions that cannot be transformed become not-a-number.
  void transform(std::vector<double>& x, std::vector<double>& y) {
    if (!transform_ || x.empty()) return;
    std::vector<int> is_done(x.size());
    transform_->Transform(static_cast<int>(x.size()), x.data(), y.data(), nullptr, nullptr, is_done.data());
    for (std::size_t i = 0; i < x.size(); ++i)
      if (!is_done[i]) x[i] = y[i] = std::nan("");
  }

 private:
  OGRSpatialReference source_, wgs84_;
  std::unique_ptr<OGRCoordinateTransformation> transform_;
  CoordinateSystem system_;
  bool has_failed_ = false;
};

}  // namespace vicus
