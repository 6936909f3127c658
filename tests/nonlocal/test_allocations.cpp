/// Counts heap allocations of the whole test program, to show that averaging allocates nothing and keeps little.
#include "nonlocal/averages.hpp"

#include "nonlocal/register.hpp"

#include <atomic>
#include <cstdlib>
#include <malloc.h>

namespace {
std::atomic<long> allocations = 0;
std::atomic<long> bytes = 0; ///< allocated and not freed

void* counted(std::size_t size, std::size_t alignment) {
  ++allocations;
  void* memory = std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
  if (memory == nullptr) throw std::bad_alloc();
  bytes += static_cast<long>(malloc_usable_size(memory));
  return memory;
}

void give_back(void* memory) noexcept {
  bytes -= static_cast<long>(malloc_usable_size(memory));
  std::free(memory);
}
} // namespace

void* operator new(std::size_t size) { return counted(size, alignof(std::max_align_t)); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return counted(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept { give_back(memory); }
void operator delete(void* memory, std::size_t) noexcept { give_back(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { give_back(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { give_back(memory); }

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
    averager->update_neighbours(x);
    averager->average(volumes.data(), field.data(), answer.data());
    const long before = allocations;
    for (int call = 0; call < 20; ++call) {
      for (Index p = 0; p < x.size(); ++p) x[0][p] += 1e-4 * p / 900; // weights are re-evaluated now and then
      averager->update_neighbours(x);
      averager->average(volumes.data(), field.data(), answer.data());
    }
    EXPECT_EQ(allocations, before);
    EXPECT_EQ(averager->searches(), 1);
  }
}

/// All memory that `gauss` keeps, including that per point, over the neighbours within 3 l_c and the skin.
TEST(Averaging, KeepsAtMostTwelveBytesPerNeighbourOfPointsInRows) {
  CatalogueOf<2> catalogue;
  register_nonlocal(catalogue);
  const auto search = catalogue.searches.find("cell_list").make();
  for (const double part : {0.0, 0.1, 0.3}) {
    Columns x = lattice<2>({32, 112}, 1.25e-3);
    shake<2>(x, part * 1.25e-3, 5);
    const Numbers volumes(static_cast<std::size_t>(x.size()), 1.0);
    Numbers answer = volumes;
    NeighbourRows rows;
    search->find(x, 3.1 * 1.5e-3, rows);
    const long before = bytes;
    const auto averager = catalogue.averagers.find("gauss").make(1.5e-3, catalogue.searches.find("cell_list").make());
    averager->update_neighbours(x);
    averager->average(volumes.data(), volumes.data(), answer.data());
    EXPECT_LE(static_cast<double>(bytes - before) / static_cast<double>(rows.index.size()), 12.0);
  }
}

} // namespace
} // namespace riedel
