#pragma once
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

/// Tiles of the flown city that the file does not have, made when first asked for: once, however many ask at a time.
namespace vicus {

struct MadeTile {
  std::string media_type;
  std::string bytes;  ///< plain
};

/// Shared by all threads.
class MadeTiles {
 public:
  /// Makes the tile of a path ("blockmaps/Z/X/Y", with ".prisms" or ".ground"); nullopt: there is no such tile.
  using Make = std::function<std::optional<MadeTile>(const std::string& path)>;
  explicit MadeTiles(Make make, std::size_t most_bytes = std::size_t{64} << 20)
      : make_(std::move(make)), most_bytes_(most_bytes) {}

  /// Null: there is no such tile. Whoever asks while it is being made waits for it; what was made is kept, and what was
  /// asked for longest ago is given up when that grows over most_bytes.
  /// `version`: another one (the city's file was replaced) forgets all.
  /// Fails   with what Make throws, for all who wait; the next asker tries again.
  std::shared_ptr<const MadeTile> get(const std::string& path, std::uint64_t version);

 private:
  struct Entry {
    bool is_done = false;  ///< made, or found not to exist, or failed
    bool is_kept = false;  ///< is in by_use_
    std::shared_ptr<const MadeTile> tile;
    std::exception_ptr failure;
    std::list<std::string>::iterator used;  ///< where is_kept
  };
  void keep(const std::string& path, const std::shared_ptr<Entry>& entry);

  Make make_;
  std::size_t most_bytes_, bytes_ = 0;
  std::uint64_t version_ = 0;
  std::mutex mutex_;
  std::condition_variable done_;
  std::map<std::string, std::shared_ptr<Entry>> entries_;
  std::list<std::string> by_use_;  ///< the latest first
};

}  // namespace vicus
