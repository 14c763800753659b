#pragma once
#include <cstddef>
#include <cstdint>

/// Chance, the same on every machine.
namespace vicus::town {

/// Never draw twice in one expression: which operand comes first is the compiler's choice.
/// splitmix64 (Steele, Lea, Flood, OOPSLA 2014): integers only, so equal seeds give equal towns everywhere.
class Rng {
 public:
  explicit Rng(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9E3779B97F4A7C15ull);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
    return z ^ (z >> 31);
  }
  /// Uniform in [0, 1).
  double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }
  double between(double low, double high) { return low + (high - low) * unit(); }
  bool chance(double probability) { return unit() < probability; }
  /// Uniform in [0, n); n > 0.
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(next() % n); }
  /// A generator of its own for one part of the town, so that a change in it moves nothing else.
  Rng fork() { return Rng(next()); }

 private:
  std::uint64_t state_;
};

}  // namespace vicus::town
