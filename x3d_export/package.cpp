#include "x3d_export/package.hpp"

#include <brotli/encode.h>
#include <libdeflate.h>
#include <openssl/sha.h>

#include <algorithm>
#include <atomic>
#include <cassert>
#include <deque>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>

#include "city_db/issues.hpp"
#include "x3d_export/root_scene.hpp"
#include "x3d_export/sector_scene.hpp"

namespace vicus {
namespace {

const std::uint8_t* bytes_of(const std::string& s) { return reinterpret_cast<const std::uint8_t*>(s.data()); }
std::uint8_t* bytes_of(std::string& s) { return reinterpret_cast<std::uint8_t*>(s.data()); }

/// Runs work(0) ... work(count - 1) on some threads. The first exception is thrown after all have stopped.
void run_parallel(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex failure_mutex;
  const auto loop = [&] {
    try {
      for (std::size_t i = next++; i < count; i = next++) work(i);
    } catch (...) {
      const std::lock_guard lock(failure_mutex);
      if (!failure) failure = std::current_exception();
      next = count;
    }
  };
  std::vector<std::thread> others;
  for (unsigned t = 1; t < threads && t < count; ++t) others.emplace_back(loop);
  loop();
  for (auto& thread : others) thread.join();
  if (failure) std::rethrow_exception(failure);
}

unsigned thread_count(const PackageOptions& options) {
  return options.threads ? options.threads : std::max(1u, std::thread::hardware_concurrency());
}

/// What pass one leaves for pass two: the near X3D files' brotli bodies, in the order of sector_files.
using NearBodies = std::vector<std::string>;

class CityArtefacts {
 public:
  CityArtefacts(City& city, const PackageOptions& options) : city_(city), index_(city), options_(options) {
    near_.resize(city.sectors.size());
    run_parallel(city.sectors.size(), thread_count(options_), [this](std::size_t i) { pack_near(i); });
    if (!city.sectors.empty() && !city.meta.contains("start")) city.meta["start"] = start_sector(source_of(index_));
  }

  std::optional<Artefact> next() {
    if (ready_.empty()) fill_ready();
    if (ready_.empty()) return std::nullopt;
    Artefact artefact = std::move(ready_.front());
    ready_.pop_front();
    return artefact;
  }

 private:
  void pack_near(std::size_t i) {
    std::uint64_t bytes = 0;
    for (const auto& file : sector_files(index_, city_.sectors[i], Detail::near, SceneFormat::x3d)) {
      near_[i].push_back(brotli(file.text, options_.brotli_quality));
      bytes += near_[i].back().size();
    }
    city_.sectors[i].bytes = bytes;
  }

  void fill_ready() {
    constexpr std::size_t kPerThread = 8;  // enough that threads seldom wait for the slowest sector
    const std::size_t count = std::min(city_.sectors.size() - done_, kPerThread * thread_count(options_));
    std::vector<std::vector<Artefact>> packed(count);
    run_parallel(count, thread_count(options_), [&](std::size_t i) { packed[i] = pack_rest(done_ + i); });
    done_ += count;
    for (auto& list : packed) std::move(list.begin(), list.end(), std::back_inserter(ready_));
  }

  std::vector<Artefact> pack_rest(std::size_t i) {
    const Sector& sector = city_.sectors[i];
    std::vector<Artefact> out;
    const auto add = [&](std::vector<Artefact> rows) { std::move(rows.begin(), rows.end(), std::back_inserter(out)); };
    const auto near = sector_files(index_, sector, Detail::near, SceneFormat::x3d);
    assert(near.size() == near_[i].size());
    int shapes = 0;
    for (std::size_t k = 0; k < near.size(); ++k) {
      add(with_brotli(near[k], std::move(near_[i][k])));
      shapes += near[k].shapes;
    }
    near_[i] = {};
    for (const auto& file : sector_files(index_, sector, Detail::far, SceneFormat::x3d))
      add(packed(file, options_.brotli_quality));
    for (const auto format : {SceneFormat::vrml, SceneFormat::x3dj})
      for (const auto& file : sector_files(index_, sector, Detail::near, format))
        add(packed(file, options_.side_quality));
    const auto record = sector_record(source_of(index_), sector, shapes);
    add(packed({"sectors/" + sector.id + ".json", "application/json", record_json(record), 0},
               options_.brotli_quality));
    return out;
  }

  std::vector<Artefact> packed(const ExportFile& file, int quality) const {
    return coded(file.path, file.media_type, file.text, quality, options_.gzip_level);
  }
  std::vector<Artefact> with_brotli(const ExportFile& file, std::string br) const;

  City& city_;
  CityIndex index_;
  PackageOptions options_;
  std::vector<NearBodies> near_;
  std::deque<Artefact> ready_;
  std::size_t done_ = 0;
};

std::vector<Artefact> rows_of(const std::string& path, const std::string& media_type, const std::string& body,
                              std::string br, std::string gz) {
  std::vector<Artefact> rows{{path, media_type, "identity", strong_hash(body), body}};
  if (br.size() < body.size()) rows.push_back({path, media_type, "br", strong_hash(br), std::move(br)});
  if (gz.size() < body.size()) rows.push_back({path, media_type, "gzip", strong_hash(gz), std::move(gz)});
  return rows;
}

std::vector<Artefact> CityArtefacts::with_brotli(const ExportFile& file, std::string br) const {
  return rows_of(file.path, file.media_type, file.text, std::move(br), gzip(file.text, options_.gzip_level));
}

}  // namespace

std::string strong_hash(const std::string& body) {
  constexpr std::size_t kBytes = 16;
  constexpr char kDigits[] = "0123456789abcdef";
  unsigned char digest[SHA256_DIGEST_LENGTH];
  SHA256(bytes_of(body), body.size(), digest);
  std::string hex;
  for (std::size_t i = 0; i < kBytes; ++i) {
    hex += kDigits[digest[i] >> 4];
    hex += kDigits[digest[i] & 15u];
  }
  return hex;
}

namespace {

/// The smallest window that holds the whole file: a larger one finds nothing more and costs its allocation.
int window_bits(std::size_t size) {
  int bits = BROTLI_MIN_WINDOW_BITS;
  while (bits < BROTLI_DEFAULT_WINDOW && (std::size_t{1} << bits) - 16 < size) ++bits;
  return bits;
}

}  // namespace

std::string brotli(const std::string& body, int quality) {
  std::size_t size = BrotliEncoderMaxCompressedSize(body.size());
  std::string out(size, '\0');
  if (!BrotliEncoderCompress(quality, window_bits(body.size()), BROTLI_MODE_TEXT, body.size(), bytes_of(body), &size,
                             bytes_of(out)))
    throw CityError("brotli cannot compress " + std::to_string(body.size()) + " bytes: out of memory");
  out.resize(size);
  return out;
}

std::string gzip(const std::string& body, int level) {
  const std::unique_ptr<libdeflate_compressor, void (*)(libdeflate_compressor*)> compressor(
      libdeflate_alloc_compressor(level), libdeflate_free_compressor);
  if (!compressor) throw CityError("libdeflate has no level " + std::to_string(level) + ", or there is no memory");
  std::string out(libdeflate_gzip_compress_bound(compressor.get(), body.size()), '\0');
  out.resize(libdeflate_gzip_compress(compressor.get(), body.data(), body.size(), out.data(), out.size()));
  return out;
}

std::vector<Artefact> coded(const std::string& path, const std::string& media_type, const std::string& body,
                            int brotli_quality, int gzip_level) {
  return rows_of(path, media_type, body, brotli(body, brotli_quality), gzip(body, gzip_level));
}

std::function<std::optional<Artefact>()> export_artefacts(City& city, const PackageOptions& options) {
  auto artefacts = std::make_shared<CityArtefacts>(city, options);
  return [artefacts] { return artefacts->next(); };
}

}  // namespace vicus
