#include "core/setup/weak_zone.hpp"

#include "core/step/stress_update.hpp"

namespace riedel {

namespace {

constexpr std::size_t max_columns = max_state_columns - 1; ///< of the law itself

/// Consecutive points of a batch, without the column that marks the zone.
class Part {
public:
  Part(const MaterialBatch& whole, Index begin, Index end) : batch(whole) {
    batch.size = end - begin;
    for (std::size_t c = 0; c < 6; ++c) {
      batch.stress[c] += begin;
      if (batch.rate[c] != nullptr) batch.rate[c] += begin;
    }
    if (batch.averaged != nullptr) batch.averaged += begin;
    if (batch.id != nullptr) batch.id += begin;
    const std::size_t own = whole.state.size() - 1;
    for (std::size_t s = 0; s < own; ++s) columns_[s] = whole.state[s] + begin;
    batch.state = {columns_.data(), own};
    if (whole.motion == nullptr) return;
    motion_ = *whole.motion;
    for (std::size_t i = 0; i < 9; ++i) {
      motion_.velocity_gradient[i] += begin;
      motion_.deformation_gradient[i] += begin;
      motion_.gradient_before[i] += begin;
      motion_.rotation[i] += begin;
    }
    batch.motion = &motion_;
  }
  Part(const Part&) = delete;
  Part& operator=(const Part&) = delete;

  MaterialBatch batch;

private:
  std::array<double*, max_columns> columns_{};
  Motion motion_;
};

} // namespace

WeakZoneLaw::WeakZoneLaw(std::unique_ptr<Material> sound, std::unique_ptr<Material> weak)
    : sound_(std::move(sound)), weak_(std::move(weak)) {
  const auto own = sound_->states();
  if (static_cast<std::size_t>(state_components(own)) > max_columns ||
      state_components(own) != state_components(weak_->states()))
    throw InputError("a weak zone: the law must declare the same state variables in it, at most " +
                     std::to_string(max_columns));
  states_.assign(own.begin(), own.end());
  states_.push_back({std::string(zone), "-", "1 where the strength is that of the weak zone"});
}

std::vector<double> WeakZoneLaw::initial_state() const {
  std::vector<double> state = sound_->initial_state();
  state.push_back(0.0);
  return state;
}

double WeakZoneLaw::density(std::span<const double> state) const {
  return at(state.back()).density(state.first(state.size() - 1));
}

/// Consecutive points that are all inside or all outside the zone, as one batch.
template <class Visit>
void WeakZoneLaw::for_each_run(const MaterialBatch& batch, const Visit& visit) const {
  const double* in_zone = batch.state.back();
  for (Index begin = 0, end = 0; begin < batch.size; begin = end) {
    while (end < batch.size && in_zone[end] == in_zone[begin]) ++end;
    const Part part(batch, begin, end);
    visit(at(in_zone[begin]), part.batch, begin);
  }
}

void WeakZoneLaw::integrate(const MaterialBatch& batch, MaterialReport& report) const {
  for_each_run(batch, [&](const Material& law, const MaterialBatch& part, Index begin) {
    MaterialReport of_part;
    law.integrate(part, of_part);
    report.add(of_part, begin);
  });
}

MaterialLimits WeakZoneLaw::assess(const MaterialBatch& batch) const {
  MaterialLimits all;
  for_each_run(batch, [&](const Material& law, const MaterialBatch& part, Index) { all.add(law.assess(part)); });
  return all;
}

} // namespace riedel
