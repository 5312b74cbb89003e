#pragma once

#include <cstdint>
#include <span>

#include <glm/vec3.hpp>

#include "film/film_file.hpp"
#include "interface.h"

namespace lavaray {

// Which samples a render takes and what they have added up to so far. The samples come in passes of work
// items, and a pass's items are traced in their order, in any division.
class Sampling {
 public:
  explicit Sampling(std::uint64_t pixels) : pixels_(pixels) {}
  virtual ~Sampling() = default;
  Sampling(const Sampling&) = delete;
  Sampling& operator=(const Sampling&) = delete;

  // Plans the next pass, once the one before is done. False where nothing is left to do.
  bool startPass();
  [[nodiscard]] std::uint64_t passItems() const { return passItems_; }
  [[nodiscard]] std::uint64_t itemsDone() const { return itemsDone_; }  // of this pass
  // Fills in those of this pass from number `first` on.
  virtual void makeItems(std::uint64_t first, std::span<gpu::WorkItem> items) const = 0;
  // The results of the items from number itemsDone() on.
  void add(std::span<const gpu::WorkResult> results);

  // The values of the pixels from number `first` on, row by row; black where there is no sample yet.
  virtual void copyValues(std::uint64_t first, std::span<glm::vec3> values) const = 0;
  [[nodiscard]] std::uint64_t pixels() const { return pixels_; }
  [[nodiscard]] virtual std::uint32_t samples(std::uint64_t pixel) const = 0;
  [[nodiscard]] virtual std::uint32_t mostSamples() const = 0;  // of a pixel
  // In units of a colour; 0 where it is not estimated, as one sequence of samples does not tell its error.
  [[nodiscard]] virtual double estimatedError(std::uint64_t /*pixel*/) const { return 0.0; }
  [[nodiscard]] virtual double estimatedError() const { return 0.0; }  // RMSE of the image

  // In [0, 1]; with a target error by the present plan.
  [[nodiscard]] virtual double shareDone() const = 0;
  // Whether all was done that was asked for, once startPass returns false.
  [[nodiscard]] virtual bool reachedGoal() const { return true; }

  // Between two pieces of work: fills in what the header says of samples, writes what comes behind it, and
  // reads both again, after which everything is as it was.
  virtual void describe(FilmHeader& header) const = 0;
  virtual void write(FilmWriter& film) const = 0;
  virtual void read(FilmReader& film) = 0;

 protected:
  void goOnAt(std::uint64_t itemsDone, std::uint64_t passItems) {
    itemsDone_ = itemsDone;
    passItems_ = passItems;
  }

 private:
  virtual std::uint64_t planPass() = 0;  // returns the number of its items
  virtual void take(std::uint64_t first, std::span<const gpu::WorkResult> results) = 0;

  std::uint64_t pixels_;
  std::uint64_t passItems_ = 0;
  std::uint64_t itemsDone_ = 0;
};

inline bool Sampling::startPass() {
  passItems_ = planPass();
  itemsDone_ = 0;
  return passItems_ > 0;
}

inline void Sampling::add(std::span<const gpu::WorkResult> results) {
  take(itemsDone_, results);
  itemsDone_ += results.size();
}

}  // namespace lavaray
