/// A search that checks every pair, and an average without weights.
#include "core/interface/plugin.hpp"

namespace {

using namespace riedel;

template <int Dim>
class PairByPair final : public NeighbourSearch<Dim> {
public:
  static constexpr std::string_view name = "pair_by_pair";

  void find(const Columns& positions, double radius, NeighbourRows& rows) override {
    rows.start.assign(1, 0);
    rows.index.clear();
    for (Index p = 0; p < positions.size(); ++p) {
      for (Index q = 0; q < positions.size(); ++q)
        if (squared_distance<Dim>(positions, p, q) <= square(radius)) rows.index.push_back(q);
      rows.start.push_back(static_cast<std::int64_t>(rows.index.size()));
    }
  }
};

template <int Dim>
class Plain final : public NonlocalAverager<Dim> {
public:
  static constexpr std::string_view name = "plain";
  Plain(double length, std::unique_ptr<NeighbourSearch<Dim>> search) : length_(length), search_(std::move(search)) {}

  void update_neighbours(const Columns& positions) override {
    search_->find(positions, length_, rows_);
    ++searches_;
  }
  void average(const double* volumes, const double* field, double* averaged) override {
    for (std::size_t p = 0; p + 1 < rows_.start.size(); ++p) {
      double sum = 0.0, volume = 0.0;
      for (std::int64_t i = rows_.start[p]; i < rows_.start[p + 1]; ++i) {
        const Index q = rows_.index[static_cast<std::size_t>(i)];
        sum += volumes[q] * field[q];
        volume += volumes[q];
      }
      averaged[p] = sum / volume;
    }
  }
  void invalidate() override {}
  [[nodiscard]] std::int64_t searches() const override { return searches_; }

private:
  double length_;
  std::unique_ptr<NeighbourSearch<Dim>> search_;
  NeighbourRows rows_;
  std::int64_t searches_ = 0;
};

} // namespace

RIEDEL_PLUGIN(riedel::neighbour_search<PairByPair>, riedel::averager<Plain>)
