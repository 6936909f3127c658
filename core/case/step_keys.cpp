#include "core/case/step_keys.hpp"

#include "core/case/plugins.hpp"
#include "core/case/transfer_keys.hpp"
#include "core/step/orders.hpp"

#include <algorithm>

namespace riedel {

namespace {

template <int Dim>
StepFunction<Dim> step_named(const std::string& order) {
  for (const StepOrder<Dim>& one : orders_of_step<Dim>)
    if (order == one.name) return one.step;
  throw InputError("unknown order of the step '" + order + "'");
}

constexpr StepDefaults standard_shares;
constexpr double most_of_volume = 0.1; ///< largest volume rate over the stress rate

std::string times(double share) { return short_text(share) + " times the rate"; }

/// The given rate, or `otherwise` for "auto" [1/s].
double rate(const Values& v, const char* key, double otherwise) { return v.is_text(key) ? otherwise : v.number(key); }

void check_stress_filter(const Values& v, const Catalogue& catalogue, std::vector<Finding>& errors) {
  const std::string of_stress = "time.stress_filter", of_volume = "time.volume_filter";
  const auto scheme = catalogue.in_2d.schemes.find(v.text("scheme")).make(v.section("interpolation"));
  if (!scheme->gradients_follow_weights() && !v.is_text(of_stress) && v.number(of_stress) > 0.0)
    errors.push_back({{of_stress, "scheme"},
                      exact_text(v.number(of_stress)) + " 1/s does not go with the scheme \"" + v.text("scheme") +
                          "\", whose gradients are not those of its weights, so the stresses on the nodes differ "
                          "from those of the filter; allowed: 0 or \"auto\", which is 0 there"});
  if (!v.is_text(of_volume) && !v.is_text(of_stress) && v.number(of_volume) > most_of_volume * v.number(of_stress))
    errors.push_back({{of_volume, of_stress},
                      exact_text(v.number(of_volume)) + " 1/s is more than a tenth of time.stress_filter, " +
                          exact_text(v.number(of_stress)) +
                          " 1/s: volumes that decay faster than their stresses add energy; allowed: up to " +
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

/// A share per step and a rate set the same quantity of a transfer that takes both.
void check_damping(const Values& v, const Catalogue& catalogue, std::vector<Finding>& errors) {
  const std::string by_step = "time.flip", by_time = "time.damping";
  const Values options(catalogue.in_2d.transfers.find(v.text("time.transfer")).description.parameters);
  const auto takes = [&](const std::string& key) { return options.has(key.substr(key.find('.') + 1)); };
  if (!takes(by_step) || !takes(by_time) || v.is_text(by_step) || v.is_text(by_time)) return;
  errors.push_back({{by_time, "time.transfer", by_step},
                    exact_text(v.number(by_time)) + " conflicts with time.flip = " + exact_text(v.number(by_step)) +
                        ", which sets the same per step; give only one of them"});
}

/// Inserts the keys of the transfers among those of the step, after `time.transfer`.
void insert_transfer_keys(Keys& keys, const Catalogue& catalogue, const std::string& of_auto) {
  Keys more = transfer_keys(catalogue, of_auto);
  more.push_back(plugin_key("time", "the transfer"));
  for (const Key& key : more)
    if (std::ranges::find(keys, key.name, &Key::name) != keys.end())
      throw PluginError("a transfer has a parameter called '" + key.name.substr(key.name.find('.') + 1) + "', but " +
                        key.name + " is a key of every step; give it another name");
  const auto transfer = std::ranges::find(keys, "time.transfer", &Key::name);
  keys.insert(transfer + 1, more.begin(), more.end());
}

} // namespace

Keys step_keys(const Catalogue& catalogue, const StepDefaults& defaults) {
  const Bounds any{};
  const StressFilter standard;
  const Bounds up_to_one{.lower = 0.0, .upper = 1.0, .lower_included = false};
  const std::vector<std::string> transfers = catalogue.in_2d.transfers.names();
  Keys keys{
      {"time.order",
       "musl",
       "",
       any,
       "when stresses are updated: last, from re-mapped velocities; last; or first",
       {"musl", "usl", "usf"}},
      {"time.step", "auto", "s", more_than(0), "time step; auto: from cfl and the wave speed in force", {"auto"}},
      {"time.cfl", 0.5, "-", up_to_one, "automatic step as a fraction of the stable one"},
      {"time.transfer", transfers.empty() ? "" : transfers.front(), "", any,
       "transfer of velocities between points and grid", transfers},
      {"time.objective_rate",
       "jaumann",
       "",
       any,
       "objective rate of the stress: with the spin of the velocities, or of R in F = R U",
       {"jaumann", "green_naghdi"}},
      {"time.locking",
       "none",
       "",
       any,
       "remedy for volumetric locking: none, or F-bar, the mean dilatation of a cell for all its points",
       {"none", "f_bar"}},
      {"time.stress_filter",
       defaults.stress_filter > 0.0 ? Value("auto") : Value(0.0),
       "1/s",
       at_least(0),
       "rate at which stresses in the null space of the grid decay; auto: " + times(standard_shares.stress_filter) +
           " at which waves cross the specimen's width; 0: they stay, as in the paper",
       {"auto"}},
      {"time.volume_filter",
       "auto",
       "1/s",
       at_least(0),
       "rate at which volume changes in the null space decay; auto: a tenth of time.stress_filter, the maximum",
       {"auto"}},
      {"time.stress_filter_order", std::int64_t{standard.order}, "-", between(1, 60),
       "m of (I - S)^m: the larger, the shorter the waves that the filter removes, and the longer it takes"},
      {"time.stress_filter_steps", std::int64_t{standard.steps_between}, "-", between(1, 100),
       "filter once in this many steps, with the same effect as in every step"},
  };
  insert_transfer_keys(
      keys, catalogue,
      times(defaults.damping) + " at which waves cross the specimen's width" +
          (defaults.slow_damp_more ? ", and below 7e-5 of strain per crossing more, in inverse proportion" : ""));
  return keys;
}

void check_step(const Values& values, const Catalogue& catalogue, std::vector<Finding>& errors) {
  check_stress_filter(values, catalogue, errors);
  check_damping(values, catalogue, errors);
  if (values.text("time.locking") == "f_bar" && values.text("time.order") == "usl")
    errors.push_back(
        {{"time.locking", "time.order"},
         "\"f_bar\" does not go with \"usl\", whose erratic strains at nodes with little mass it spreads over "
         "the cell; take time.order = \"musl\" or \"usf\""});
}

bool filters_stresses(const Values& v) { return rate(v, "time.stress_filter", standard_shares.stress_filter) > 0.0; }

template <int Dim>
void set_step(Model<Dim>& model, const Values& v, const Catalogue& catalogue, double crossing_rate,
              const StepDefaults& defaults) {
  model.step = step_named<Dim>(v.text("time.order"));
  if (v.text("time.objective_rate") == "green_naghdi") model.objective_rate = ObjectiveRate::green_naghdi;
  if (v.text("time.locking") == "f_bar") model.locking = Locking::f_bar;
  model.transfer = make_transfer<Dim>(v, catalogue, defaults.damping * crossing_rate);
  const double usual = model.scheme->gradients_follow_weights() ? standard_shares.stress_filter * crossing_rate : 0.0,
               of_stress = rate(v, "time.stress_filter", usual);
  model.stress_filter = {.stress_rate = of_stress,
                         .volume_rate = rate(v, "time.volume_filter", most_of_volume * of_stress),
                         .order = static_cast<int>(v.integer("time.stress_filter_order")),
                         .steps_between = static_cast<int>(v.integer("time.stress_filter_steps"))};
  model.cfl = v.number("time.cfl");
  if (!v.is_text("time.step")) model.fixed_time_step = v.number("time.step");
}

template void set_step<2>(Model<2>&, const Values&, const Catalogue&, double, const StepDefaults&);
template void set_step<3>(Model<3>&, const Values&, const Catalogue&, double, const StepDefaults&);

} // namespace riedel
