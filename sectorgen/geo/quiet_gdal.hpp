#pragma once
#include <cpl_error.h>
#include <gdal.h>

/// GDAL as the readers use it.
namespace vicus {

/// While it lives, GDAL's drivers are there and its messages go to CityError or nowhere, never to stderr.
struct QuietGdal {
  QuietGdal() {
    GDALAllRegister();
    CPLPushErrorHandler(CPLQuietErrorHandler);
    CPLErrorReset();
  }
  ~QuietGdal() { CPLPopErrorHandler(); }
  QuietGdal(const QuietGdal&) = delete;
  QuietGdal& operator=(const QuietGdal&) = delete;
};

}  // namespace vicus
