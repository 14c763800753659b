#pragma once
#include "cli/measure_representation.hpp"
#include "cli/measure_shared_city.hpp"
#include "x3d_export/glb.hpp"

namespace vicus::measure {

/// Sectors as binary glTF: near ones (level 3, images inside) where the 2.5 m that a far one may lack
/// (x3d_export/tileset) are more than `tau_px` on screen, else far ones; from the street those of L_1, from the air
/// all. Pictures are of what decoders give back.
Form glb_files(SharedCity& city, GlbCoding coding, double tau_px);

}  // namespace vicus::measure
