#pragma once
#include <optional>
#include <vector>

#include "city_db/city.hpp"
#include "sectorgen/models/canvas.hpp"
#include "sectorgen/models/photo_list.hpp"

namespace vicus {

/// Photos in place of painted facades (paper 004 §4.2, third level of detail): each is drawn straight into a power of
/// two of pixels, at most 512, and becomes the texture of its facade; the house's wall takes the photo's colour beside
/// the windows, and the facade as many bays and storeys as the table says, else as repeat in the photo beyond doubt,
/// else as laid out. A house that the city does not have, or that shows no facade there, is issue 104. Needs   facades
/// laid out (facades.hpp), not yet painted: paint_textures leaves these alone. Fails   CityError: a photo that cannot
/// be read. Differs windows of levels 2 and 4 keep the city's own images: cut out of one photo they would show its
/// reflections
///         in every window.
void hang_photos(const std::vector<FacadePhoto>& photos, City& city);

/// One picture as the facade's texture. A facade with openings of its own keeps them. Needs   the house is its own.
void hang_picture(const Canvas& picture, std::optional<int> bays, std::optional<int> floors, Facade& facade,
                  Building& house, City& city);

/// Pixels along a side of a photo's texture.
int photo_side(double side_m);

}  // namespace vicus
