#include "apps/reproduce/element_figures.hpp"

#include "apps/kinds.hpp"

#include <algorithm>
#include <cmath>

namespace riedel {

namespace {

const std::vector<std::string> loose_to_dense{"0.6", "0.75", "0.9"};

struct ElementFigure {
  std::string name; ///< of its runs
  std::string test;
  std::vector<std::string> settings;
  std::string subject; ///< behind the title
  /// Number of the figure, name of the part, file name of the element test's picture
  std::vector<std::tuple<int, std::string, std::string>> parts;
};

const std::vector<ElementFigure>& all_element_figures() {
  static const std::vector<ElementFigure> all{
      {"oedometer", "oedometer", {}, "", {{2, "2a", "stress_strain.png"}, {2, "2b", "compression.png"}}},
      {"triaxial_500kPa",
       "triaxial",
       {},
       ", σ_c = 500 kPa",
       {{3, "3", "stress_strain.png"}, {4, "4a_500", "friction.png"}, {4, "4b_500", "void_ratio.png"}}},
      {"triaxial_50kPa",
       "triaxial",
       {"loading.confining_pressure=50e3"},
       ", σ_c = 50 kPa",
       {{4, "4a_50", "friction.png"}, {4, "4b_50", "void_ratio.png"}}},
      {"shear_200kPa", "shear", {}, ", σ_n = 200 kPa", {{5, "5a_200", "friction.png"}}},
      {"shear_50kPa", "shear", {"loading.normal_stress=50e3"}, ", σ_n = 50 kPa", {{5, "5b_50", "friction.png"}}},
  };
  return all;
}

/// Three of triaxial compression at 500 kPa, far enough to reach the critical state.
const ElementFigure to_the_end{"triaxial_to_the_end", "triaxial", {"loading.final_strain=0.7"}, "", {}};

std::string run_name(const ElementFigure& figure, const std::string& void_ratio) {
  return figure.name + "_e" + void_ratio;
}

Variant variant_of(const ElementFigure& figure, const std::string& void_ratio) {
  Variant variant{.given = CaseFile::empty(), .name = run_name(figure, void_ratio), .label = "e₀ = " + void_ratio};
  std::vector<std::string> settings{"test=" + figure.test, "output.plots=false"};
  settings.insert(settings.end(), figure.settings.begin(), figure.settings.end());
  settings.push_back("specimen.void_ratio=" + void_ratio);
  for (const std::string& setting : settings) variant.given.override_with(setting, "riedel reproduce:");
  return variant;
}

bool is_wanted(const ElementFigure& figure, const Figures& figures) {
  return std::ranges::any_of(figure.parts, [&](const auto& part) { return figures.contains(std::get<0>(part)); });
}

std::vector<RunResult> runs_of(const ElementFigure& figure, Runs runs) {
  std::vector<RunResult> own;
  for (const std::string& void_ratio : loose_to_dense)
    if (const auto run = std::ranges::find(runs, run_name(figure, void_ratio), &RunResult::name);
        run != runs.end() && run->status == RunStatus::done)
      own.push_back(*run);
  return own;
}

} // namespace

double critical_void_ratio(const Values& law, double pressure) {
  return law.number("e_c0") * std::exp(-std::pow(3.0 * pressure / law.number("h_s"), law.number("n")));
}

std::vector<Variant> element_runs(const Figures& figures) {
  std::vector<Variant> variants;
  const auto add = [&](const ElementFigure& figure) {
    for (const std::string& void_ratio : loose_to_dense) variants.push_back(variant_of(figure, void_ratio));
  };
  for (const ElementFigure& figure : all_element_figures())
    if (is_wanted(figure, figures)) add(figure);
  if (!variants.empty()) add(to_the_end);
  return variants;
}

std::vector<FigurePart> element_figures(const Figures& figures, Runs runs) {
  std::vector<FigurePart> found;
  for (const ElementFigure& each : all_element_figures()) {
    if (!is_wanted(each, figures)) continue;
    const std::vector<NamedPlot> plots = run_kind("element").plots(runs_of(each, runs), each.subject);
    for (const auto& [figure, name, file] : each.parts)
      if (const auto plot = std::ranges::find(plots, file, &NamedPlot::file);
          figures.contains(figure) && plot != plots.end())
        found.push_back({figure, name, "Figure " + name, plot->plot});
  }
  std::ranges::stable_sort(found, {}, &FigurePart::name);
  return found;
}

CriticalState triaxial_end(Runs runs, const Values& law) {
  CriticalState end;
  for (const RunResult& run : runs_of(to_the_end, runs)) {
    const auto last = [&](const char* column) { return run.history[column].back(); };
    end.angle.push_back(last("phi_mob_deg"));
    end.void_ratio.push_back(last("void_ratio"));
    end.expected_void_ratio =
        critical_void_ratio(law, (last("sigma_1_Pa") + last("sigma_2_Pa") + last("sigma_3_Pa")) / 3.0);
  }
  return end;
}

} // namespace riedel
