#include "core/case/step_keys.hpp"

#include "core/case/transfer_keys.hpp"
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

constexpr StepDefaults standard_shares;
constexpr double most_of_volume = 0.1; ///< of the rate of the stresses

std::string times(double share) { return short_text(share) + " times the rate"; }

/// The rate that was given, or `otherwise` for "auto" [1/s].
double rate(const Values& v, const char* key, double otherwise) { return v.is_text(key) ? otherwise : v.number(key); }

void check_stress_filter(const Values& v, const Catalogue& catalogue, std::vector<Finding>& errors) {
  const std::string of_stress = "time.stress_filter", of_volume = "time.volume_filter";
  const auto scheme = catalogue.in_2d.schemes.find(v.text("scheme")).make(v.section("interpolation"));
  if (!scheme->slopes_follow_weights() && !v.is_text(of_stress) && v.number(of_stress) > 0.0)
    errors.push_back({{of_stress, "scheme"},
                      exact_text(v.number(of_stress)) + " 1/s does not go with the scheme \"" + v.text("scheme") +
                          "\", whose slopes are not the gradients of its weights: nodes see other stresses than the "
                          "filter, which goes by the weights; allowed: 0 or \"auto\", which is 0 there"});
  if (!v.is_text(of_volume) && !v.is_text(of_stress) && v.number(of_volume) > most_of_volume * v.number(of_stress))
    errors.push_back({{of_volume, of_stress},
                      exact_text(v.number(of_volume)) + " 1/s is more than a tenth of time.stress_filter, " +
                          exact_text(v.number(of_stress)) +
                          " 1/s: volumes that fade faster than their stresses feed energy in; allowed: up to " +
                          exact_text(most_of_volume * v.number(of_stress)) + " 1/s"});
  if (filters_stresses(v)) return;
  const StressFilter standard;
  for (const auto& [key, usual] :
       {std::pair{"time.stress_filter_order", standard.order}, {"time.stress_filter_steps", standard.steps_between}})
    if (v.integer(key) != usual)
      errors.push_back({{key, of_stress},
                        std::to_string(v.integer(key)) + " means nothing to a filter without a rate; give "
                                                         "time.stress_filter a rate, or leave this out"});
}

/// A number that nothing would look at. Defaults pass: a run leaves them in its case.toml.
void check_damping(const Values& v, std::vector<Finding>& errors) {
  const std::string& transfer = v.text("time.transfer");
  const bool by_step = !v.is_text("time.flip"), by_time = !v.is_text("time.damping");
  const auto idle = [&](const std::string& key, double value, const std::string& why) {
    errors.push_back({{key, "time.transfer", "time.flip"}, exact_text(value) + " means nothing " + why});
  };
  const std::string to_others =
      "to \"" + transfer + "\", which blends no FLIP and PIC; leave it out, or take " + "time.transfer = \"flip\"";
  if (transfer != "flip") {
    if (by_step) idle("time.flip", v.number("time.flip"), to_others);
    if (by_time) idle("time.damping", v.number("time.damping"), to_others);
  } else if (by_step && by_time) {
    idle("time.damping", v.number("time.damping"),
         "beside time.flip = " + exact_text(v.number("time.flip")) + ", which says the same by step; give one of them");
  }
}

} // namespace

Keys step_keys(const StepDefaults& defaults) {
  const Bounds any{};
  const StressFilter standard;
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
      {"time.damping",
       "auto",
       "1/s",
       at_least(0),
       "rate at which what the grid does not see of the points' velocities fades; auto: " + times(defaults.damping) +
           " at which waves cross the specimen's width" +
           (defaults.slow_damp_more ? ", and below 7e-5 of strain in a crossing in inverse proportion more" : "") +
           "; for flip alone",
       {"auto"}},
      {"time.flip",
       "damping",
       "-",
       between(0, 1),
       "share of FLIP in a step, the rest is PIC; damping: e^(-time.damping dt), so that steps of any size damp alike; "
       "for flip alone",
       {"damping"}},
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
      {"time.stress_filter",
       defaults.stress_filter > 0.0 ? Value("auto") : Value(0.0),
       "1/s",
       at_least(0),
       "rate at which stresses that no node sees fade; auto: " + times(standard_shares.stress_filter) +
           " at which waves cross the specimen's width; 0: they stay, as in the paper",
       {"auto"}},
      {"time.volume_filter",
       "auto",
       "1/s",
       at_least(0),
       "rate at which changes of volume that no node sees fade; auto: a tenth of time.stress_filter, which is the most",
       {"auto"}},
      {"time.stress_filter_order", std::int64_t{standard.order}, "-", between(1, 60),
       "m of (I - S)^m: the greater, the shorter the waves that the filter takes, and the longer it takes"},
      {"time.stress_filter_steps", std::int64_t{standard.steps_between}, "-", between(1, 100),
       "filter in every so many steps, as much as in all of them"},
  };
}

void check_step(const Values& values, const Catalogue& catalogue, std::vector<Finding>& errors) {
  check_stress_filter(values, catalogue, errors);
  check_damping(values, errors);
  if (values.text("time.locking") == "f_bar" && values.text("time.order") == "usl")
    errors.push_back(
        {{"time.locking", "time.order"},
         "\"f_bar\" does not go with \"usl\", whose wild strains at nodes with little mass it spreads over "
         "the cell; take time.order = \"musl\" or \"usf\""});
}

bool filters_stresses(const Values& v) { return rate(v, "time.stress_filter", standard_shares.stress_filter) > 0.0; }

template <int Dim>
void set_step(Model<Dim>& model, const Values& v, double crossing_rate, const StepDefaults& defaults) {
  model.step = step_named<Dim>(v.text("time.order"));
  if (v.text("time.objective_rate") == "green_naghdi") model.objective_rate = ObjectiveRate::green_naghdi;
  if (v.text("time.locking") == "f_bar") model.locking = Locking::f_bar;
  model.transfer = transfer_named(v.text("time.transfer"));
  if (v.is_text("time.flip"))
    model.damping = rate(v, "time.damping", defaults.damping * crossing_rate);
  else
    model.flip = v.number("time.flip");
  const double usual = model.scheme->slopes_follow_weights() ? standard_shares.stress_filter * crossing_rate : 0.0,
               of_stress = rate(v, "time.stress_filter", usual);
  model.stress_filter = {.stress_rate = of_stress,
                         .volume_rate = rate(v, "time.volume_filter", most_of_volume * of_stress),
                         .order = static_cast<int>(v.integer("time.stress_filter_order")),
                         .steps_between = static_cast<int>(v.integer("time.stress_filter_steps"))};
  model.xpic_order = static_cast<int>(v.integer("time.xpic_order"));
  model.cfl = v.number("time.cfl");
  if (!v.is_text("time.step")) model.fixed_time_step = v.number("time.step");
}

template void set_step<2>(Model<2>&, const Values&, double, const StepDefaults&);
template void set_step<3>(Model<3>&, const Values&, double, const StepDefaults&);

} // namespace riedel
