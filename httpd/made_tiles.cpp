#include "httpd/made_tiles.hpp"

namespace vicus {

std::shared_ptr<const MadeTile> MadeTiles::get(const std::string& path, std::uint64_t version) {
  std::unique_lock lock(mutex_);
  if (version != version_) {  // those being made go on without us; their askers have them still
    entries_.clear();
    by_use_.clear();
    bytes_ = 0;
    version_ = version;
  }
  if (const auto found = entries_.find(path); found != entries_.end()) {
    const auto entry = found->second;
    if (entry->is_kept) {
      by_use_.splice(by_use_.begin(), by_use_, entry->used);
      return entry->tile;
    }
    done_.wait(lock, [&] { return entry->is_done; });
    if (entry->failure) std::rethrow_exception(entry->failure);
    return entry->tile;
  }
  const auto entry = std::make_shared<Entry>();
  entries_.emplace(path, entry);
  lock.unlock();
  std::shared_ptr<const MadeTile> tile;
  std::exception_ptr failure;
  try {
    if (auto made = make_(path)) tile = std::make_shared<const MadeTile>(*std::move(made));
  } catch (...) {
    failure = std::current_exception();
  }
  lock.lock();
  const auto own = entries_.find(path);
  const bool is_current = own != entries_.end() && own->second == entry;
  entry->is_done = true;
  entry->tile = tile;
  entry->failure = failure;
  if (is_current && tile) keep(path, entry);
  // Nothing else is kept: a stranger may ask for any number of tiles that do not exist.
  if (is_current && !tile) entries_.erase(own);
  lock.unlock();
  done_.notify_all();
  if (failure) std::rethrow_exception(failure);
  return tile;
}

void MadeTiles::keep(const std::string& path, const std::shared_ptr<Entry>& entry) {
  by_use_.push_front(path);
  entry->used = by_use_.begin();
  entry->is_kept = true;
  bytes_ += entry->tile->bytes.size();
  while (bytes_ > most_bytes_ && by_use_.size() > 1) {
    const auto last = entries_.find(by_use_.back());
    bytes_ -= last->second->tile->bytes.size();
    entries_.erase(last);
    by_use_.pop_back();
  }
}

}  // namespace vicus
