#pragma once
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// An author's table of photos of facades.
///
/// CSV     first line names the columns, in any order: house, file, and any of heading, corners, bays, floors. house: a
///         building's id or its name in the map's file (way/123); file: beside the table; heading: where the facade
///         looks, degrees clockwise from north (else the house's longest one); corners: "x y x y x y x y", pixels from
///         the photo's top left, of the facade's bottom left, bottom right, top right, top left (else the whole photo);
///         bays, floors: how many windows in a row, and storeys (else as found in the photo). Lines that begin with #
///         are passed over.
namespace vicus {

struct FacadePhoto {
  std::string house;
  std::filesystem::path file;
  std::optional<double> heading_deg;
  std::optional<std::array<double, 8>> corners;
  std::optional<int> bays, floors;
  std::string source_id;  ///< FILE#LINE, from 1
};

/// Fails   CityError, naming file and line.
std::vector<FacadePhoto> read_photo_list(const std::filesystem::path& list);

}  // namespace vicus
