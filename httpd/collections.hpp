#pragma once
#include "city_db/store.hpp"
#include "httpd/message.hpp"
#include "httpd/url.hpp"

/// Sectors, gates and houses for GIS: OGC API - Features, part 1 (17-069r4), core and GeoJSON.
///
///   /                              landing page, where JSON is asked for
///   /conformance                   classes we claim
///   /api                           OpenAPI 3.0 description of these paths
///   /collections[/NAME]            NAME: sectors, gates, houses
///   /collections/NAME/items        ?bbox=W,S,E,N&limit=10&offset=0; links to the next page
///   /collections/NAME/items/ID
///
/// `offset` counts the records whose plan box meets the bbox's: a page may hold fewer than `limit` features and yet
/// have a next one. Coordinates are CRS84 (longitude, latitude).
namespace vicus {

HttpResponse answer_landing(const HttpRequest& request);
HttpResponse answer_api(const HttpRequest& request);

/// Needs   url.path is "/conformance", "/collections" or begins with "/collections/".
/// Fails   CityError: the city gives no origin.
HttpResponse answer_collections(const HttpRequest& request, const Url& url, const CityReader& city);

}  // namespace vicus
