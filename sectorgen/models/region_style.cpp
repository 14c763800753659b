#include "sectorgen/models/region_style.hpp"

#include <algorithm>

namespace vicus {
namespace {

constexpr std::uint32_t kCentralPlaster[] = {0xe3d8c1, 0xd9c9a8, 0xe9dfcf, 0xd6cdbd,
                                             0xdcc3a0, 0xd2b896, 0xdcd4c8, 0xe0cdb8};
constexpr std::uint32_t kCentralStone[] = {0xe3d8c1, 0xd9cbb0, 0xdcd4c8, 0xd2c3a6};
constexpr std::uint32_t kCentralBrick[] = {0x9c5a45, 0xa9674e, 0x8a5242};
constexpr std::uint32_t kTiles[] = {0xa5573f, 0x98503c, 0xb0634a, 0x8e4c3b, 0x7a5648, 0x59606a, 0x676d73};
constexpr std::uint32_t kGravelAndFelt[] = {0x9d978c, 0xaaa69d, 0x8d8a84, 0x787673, 0x6c6b69, 0xb4b1a9};

constexpr std::uint32_t kParisPlaster[] = {0xe3d8c1, 0xe9dfcf, 0xd9cdb4, 0xdcd4c8, 0xe6dcc8};
constexpr std::uint32_t kLimestone[] = {0xe3d8c1, 0xd9cbb0, 0xdfd3b9, 0xd8ccb4};
constexpr std::uint32_t kZincAndSlate[] = {0x8e989f, 0x99a2a8, 0x868f97, 0xa3abb0, 0x8e989f, 0x676d73, 0x59606a};
constexpr std::uint32_t kParisFlat[] = {0xa8a49b, 0x9a968e, 0xb4b1a9, 0x8a8882, 0x8e989f};

constexpr std::uint32_t kStucco[] = {0xece6da, 0xe4ddce, 0xf0ebe0, 0xd9d0bd};
constexpr std::uint32_t kPortland[] = {0xd8cfb8, 0xcfc3a5, 0xddd5c4};
constexpr std::uint32_t kStockBrick[] = {0x9c5a45, 0x8f5440, 0xb08a5e, 0xa67f58};
constexpr std::uint32_t kSlate[] = {0x596069, 0x5f6570, 0x6b7077, 0x747a80, 0x7a4f40, 0x8e5a45};

constexpr std::uint32_t kDutchPlaster[] = {0xece6da, 0xe3d8c1, 0xdcd4c8, 0xe9dfcf};
constexpr std::uint32_t kDutchBrick[] = {0x8e4f3d, 0x9c5a45, 0xa8684f, 0x7d4a3c};
constexpr std::uint32_t kPantiles[] = {0x98503c, 0xa5573f, 0xb0634a, 0x5a4f4a, 0x4f5257, 0x6b6560};

constexpr std::uint32_t kWarmPlaster[] = {0xe8d3b0, 0xe3c59a, 0xdfb78e, 0xead9bd, 0xd9b38c, 0xe6cfae};
constexpr std::uint32_t kWarmStone[] = {0xdccaa6, 0xd5c19a, 0xe2d4b6};
constexpr std::uint32_t kRomanTiles[] = {0xb8714d, 0xc07f58, 0xb26a48, 0xc58c66, 0xa96244};

constexpr RegionStyle kCentralEurope{
    "Central Europe", kCentralPlaster, kCentralStone, kCentralBrick, kTiles, kGravelAndFelt, 7, 0, 1, false};
constexpr RegionStyle kParis{"Paris", kParisPlaster, kLimestone, kCentralBrick, kZincAndSlate, kParisFlat, 7, 0,
                             1,       true};
constexpr RegionStyle kLowCountries{
    "the Low Countries", kDutchPlaster, kPortland, kDutchBrick, kPantiles, kGravelAndFelt, 1, 6, 8, false};
constexpr RegionStyle kBritishIsles{"the British Isles", kStucco, kPortland, kStockBrick, kSlate,
                                    kGravelAndFelt,      3,       5,         6,           false};
constexpr RegionStyle kMediterranean{
    "the Mediterranean", kWarmPlaster, kWarmStone, kCentralBrick, kRomanTiles, kGravelAndFelt, 4, 0, 0, false};

struct Region {
  double south_deg, west_deg, north_deg, east_deg;
  const RegionStyle* style;
};

// By area, the smallest first.
constexpr Region kRegions[] = {{48.75, 2.2, 48.95, 2.5, &kParis},
                               {50.7, 2.5, 53.7, 7.1, &kLowCountries},
                               {49.8, -10.8, 61, 1.8, &kBritishIsles},
                               {34, -10, 44.2, 28.5, &kMediterranean}};

}  // namespace

const RegionStyle& region_style(LatLon place) {
  const auto* const region = std::find_if(std::begin(kRegions), std::end(kRegions), [&](const Region& r) {
    return place.lat_deg >= r.south_deg && place.lat_deg <= r.north_deg && place.lon_deg >= r.west_deg &&
           place.lon_deg <= r.east_deg;
  });
  return region == std::end(kRegions) ? kCentralEurope : *region->style;
}

}  // namespace vicus
