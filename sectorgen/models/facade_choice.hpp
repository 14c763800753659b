#pragma once
#include "city_db/facade_layout.hpp"
#include "sectorgen/models/region_style.hpp"

/// What a house's facades look like, from its tags, size, region and id. No clicks (paper 004 §4.2 needed an author).
namespace vicus {

FacadeStyle style_of(const Building& house, const RegionStyle& region);

/// Storeys of a facade of `height_m`: as tagged where that makes storeys of 2.2 to 6 m, else the style's own.
int floors_of(const Building& house, FacadeStyle style, double height_m);

/// Bays and repeats of the pattern for a facade of `length_m`; false: too short or too low for a window.
bool lay_out_bays(Facade& facade);

}  // namespace vicus
