#include "core/run/relax.hpp"

namespace riedel {

double relax(Simulation<2>& simulation, Index steps, Run<2> run) {
  double before = 0.0, maximum = 0.0, now = 0.0;
  run.after_steps(1, [&] {
    now = simulation.energies().kinetic;
    maximum = std::max(maximum, now);
    if (now < before)
      for (Body<2>& body : simulation.state().bodies)
        for (const int a : {0, 1}) body.points.velocity.fill(a, 0.0);
    before = now < before ? 0.0 : now;
  });
  run.until_step(simulation.state().step + steps).go();
  return now / maximum;
}

} // namespace riedel
