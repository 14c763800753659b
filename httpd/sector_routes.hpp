#pragma once
#include <string>

#include "city_db/store.hpp"
#include "httpd/message.hpp"
#include "httpd/url.hpp"

/// /city.* (root worlds) and /sectors/*.
namespace vicus {

/// Letters, digits, '-' and '_', 200 at most: what can be the id of a sector.
bool is_sector_id(const std::string& id);

/// Needs   url.path is "/city" or begins with "/city.".
/// /flyover.x3d: the city from above.
HttpResponse answer_flyover(const HttpRequest& request, const CityReader& city);
HttpResponse answer_root(const HttpRequest& request, const Url& url, const CityReader& city);

/// `name`: what follows /sectors/, e.g. "r12.x3d", "r12.far.x3d", "r12.2.x3d", or "r12" to choose by Accept.
HttpResponse answer_sector(const HttpRequest& request, const CityReader& city, const std::string& name);

}  // namespace vicus
