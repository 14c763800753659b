#pragma once
#include <array>
#include <filesystem>
#include <optional>

#include "sectorgen/models/canvas.hpp"

namespace vicus {

/// The part of a photo between four corners, drawn straight: corners as in FacadePhoto; none: the whole photo.
/// Error   by a projective map, which is exact for a flat facade and a lens without distortion; resampled with a filter
/// as
///         wide as the pixels are drawn apart (OpenImageIO).
/// Fails   CityError: no picture, of no size, or larger than 100 million pixels.
Canvas rectified(const std::filesystem::path& photo, const std::optional<std::array<double, 8>>& corners, int width,
                 int height, double width_m, double height_m);

}  // namespace vicus
