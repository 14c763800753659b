#pragma once
#include <functional>
#include <string>
#include <vector>

#include "city_db/store.hpp"
#include "city_db/tour.hpp"
#include "httpd/message.hpp"
#include "httpd/url.hpp"

/// /tours and /search (DESIGN §10).
namespace vicus {

/// Who knows the ways: what the server asks of it. Called from many threads at once. Empty: this server knows none.
struct TourDesk {
  std::function<TourAnswer(const TourQuery&)> tour;
  std::function<std::vector<TourPlace>(const std::string& typed, std::size_t limit)> search;
  std::function<std::vector<TourProposal>()> proposals;
};

/// /tours                       the ready-made tours
/// /tours?from=&to=             a tour; via= (again and again), round=1; or tour=ID: a ready-made one
/// /tours.x3d?...               the same as a world that walks by itself
/// 400 for what is no query, 404 for unknown places, 409 where no way leads from stop to stop.
HttpResponse answer_tours(const HttpRequest& request, const Url& url, const CityReader& city, const TourDesk& desk);

/// /search?q=&limit=            places by name, best first
HttpResponse answer_search(const HttpRequest& request, const Url& url, const TourDesk& desk);

inline constexpr std::size_t kMostSearched_bytes = 120, kDefaultResults = 10, kMostResults = 50;

}  // namespace vicus
