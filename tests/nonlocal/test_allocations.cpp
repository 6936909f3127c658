/// Counts what the whole test program takes from the heap, to show that averaging takes nothing.
#include "nonlocal/clouds.hpp"

#include "nonlocal/register.hpp"

#include <atomic>
#include <cstdlib>
#include <gtest/gtest.h>

namespace {
std::atomic<long> allocations = 0;

void* counted(std::size_t size, std::size_t alignment) {
  ++allocations;
  void* memory = std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}
} // namespace

void* operator new(std::size_t size) { return counted(size, alignof(std::max_align_t)); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return counted(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

namespace riedel {
namespace {

TEST(Averaging, TakesNoMemoryBetweenSearches) {
  CatalogueOf<2> catalogue;
  register_nonlocal(catalogue);
  for (const auto& entry : catalogue.averagers.entries()) {
    SCOPED_TRACE(entry.description.name);
    const auto averager = entry.make(0.06, catalogue.searches.find("cell_list").make());
    Columns x = random_points<2>(900, 1.0);
    const std::vector<double> volumes(900, 1.0), field(900, 2.0);
    std::vector<double> answer(900);
    averager->follow(x);
    averager->average(volumes.data(), field.data(), answer.data());
    const long before = allocations;
    for (int call = 0; call < 20; ++call) {
      for (Index p = 0; p < x.size(); ++p) x[0][p] += 1e-4 * p / 900; // weights are evaluated anew now and then
      averager->follow(x);
      averager->average(volumes.data(), field.data(), answer.data());
    }
    EXPECT_EQ(allocations, before);
    EXPECT_EQ(averager->searches(), 1);
  }
}

} // namespace
} // namespace riedel
