#include "apps/step_keys.hpp"

#include "apps/velocity_transfers.hpp"
#include "core/step/musl.hpp"
#include "core/step/usf.hpp"
#include "core/step/usl.hpp"

namespace riedel {

namespace {

template <int Dim>
StepFunction<Dim> step_named(const std::string& order) {
  if (order == "musl") return musl_step<Dim>;
  if (order == "usl") return usl_step<Dim>;
  return usf_step<Dim>;
}

} // namespace

Keys step_keys() {
  const Bounds any{};
  const Bounds up_to_one{.lower = 0.0, .upper = 1.0, .lower_included = false};
  return {
      {"time.order",
       "musl",
       "",
       any,
       "when stresses are updated: last, from re-mapped velocities; last; or first",
       {"musl", "usl", "usf"}},
      {"time.step", "auto", "s", more_than(0), "time step; auto: from cfl and the wave speed in force", {"auto"}},
      {"time.cfl", 0.5, "-", up_to_one, "automatic step as a fraction of the stable one"},
      {"time.transfer", "flip", "", any,
       "velocities between points and grid: a blend of FLIP and PIC, affine (APIC, TPIC), or XPIC(m)",
       transfer_names()},
      {"time.flip", 0.98, "-", between(0, 1), "share of FLIP in the points' velocity, the rest is PIC; for flip alone"},
      {"time.xpic_order", std::int64_t{2}, "-", between(1, 40), "m of XPIC(m), 1 is PIC; for xpic alone"},
      {"time.objective_rate",
       "jaumann",
       "",
       any,
       "rate of the stress that does not see rotations: with the spin of the velocities, or of R in F = R U",
       {"jaumann", "green_naghdi"}},
      {"time.locking",
       "none",
       "",
       any,
       "cure of volumetric locking: none, or F-bar, the mean dilatation of a cell for all its points",
       {"none", "f_bar"}},
  };
}

void check_step(const Values& values, std::vector<Finding>& errors) {
  if (values.text("time.locking") == "f_bar" && values.text("time.order") == "usl")
    errors.push_back(
        {{"time.locking", "time.order"},
         "\"f_bar\" does not go with \"usl\", whose wild strains at nodes with little mass it spreads over "
         "the cell; take time.order = \"musl\" or \"usf\""});
}

template <int Dim>
void set_step(Model<Dim>& model, const Values& v) {
  model.step = step_named<Dim>(v.text("time.order"));
  if (v.text("time.objective_rate") == "green_naghdi") model.objective_rate = ObjectiveRate::green_naghdi;
  if (v.text("time.locking") == "f_bar") model.locking = Locking::f_bar;
  model.transfer = transfer_named(v.text("time.transfer"));
  model.flip = v.number("time.flip");
  model.xpic_order = static_cast<int>(v.integer("time.xpic_order"));
  model.cfl = v.number("time.cfl");
  if (!v.is_text("time.step")) model.fixed_time_step = v.number("time.step");
}

template void set_step<2>(Model<2>&, const Values&);
template void set_step<3>(Model<3>&, const Values&);

} // namespace riedel
