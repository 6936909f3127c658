#include "core/run/watches.hpp"

#include "core/io/messages.hpp"

#include <algorithm>
#include <cmath>

namespace riedel {

void KineticShare::record(double strain, const Energies& now) {
  if (strain >= settled && now.internal != 0.0) maximum_ = std::fmax(maximum_, now.kinetic / std::abs(now.internal));
}

std::string TimeStepWatch::doubt() const {
  if (maximum_ <= 1.0) return "";
  return "the time step was " + short_text(maximum_) +
         " times the stable one: do not trust the result; use a smaller time.step, or \"auto\"";
}

void TimeStepWatch::record(double time_step, double limit, std::int64_t step) {
  const double share = time_step / limit;
  if (share > 1.0 && maximum_ <= 1.0)
    print_warning("time.step = " + short_text(time_step) + " s is over the stable limit, " + short_text(limit) +
                  " s at step " + std::to_string(step) +
                  ": the run may become unstable, or give wrong results without warning");
  maximum_ = std::max(maximum_, share);
}

} // namespace riedel
