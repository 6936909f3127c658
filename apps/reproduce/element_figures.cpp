#include "apps/reproduce/element_figures.hpp"

#include "apps/element/drivers.hpp"
#include "apps/element/keys.hpp"

#include <algorithm>
#include <cmath>

namespace riedel {

namespace {

const std::vector<std::string> loose_to_dense{"0.6", "0.75", "0.9"};

struct ElementFigure {
  std::string test;
  std::vector<std::string> settings;
  std::string subject; ///< behind the title
  /// Number of the figure, name of the part, file name of the element test's picture
  std::vector<std::tuple<int, std::string, std::string>> parts;
};

const std::vector<ElementFigure>& all_element_figures() {
  static const std::vector<ElementFigure> all{
      {"oedometer", {}, "", {{2, "2a", "stress_strain.png"}, {2, "2b", "compression.png"}}},
      {"triaxial",
       {},
       ", σ_c = 500 kPa",
       {{3, "3", "stress_strain.png"}, {4, "4a_500", "friction.png"}, {4, "4b_500", "void_ratio.png"}}},
      {"triaxial",
       {"loading.confining_pressure=50e3"},
       ", σ_c = 50 kPa",
       {{4, "4a_50", "friction.png"}, {4, "4b_50", "void_ratio.png"}}},
      {"shear", {}, ", σ_n = 200 kPa", {{5, "5a_200", "friction.png"}}},
      {"shear", {"loading.normal_stress=50e3"}, ", σ_n = 50 kPa", {{5, "5b_50", "friction.png"}}},
  };
  return all;
}

Values element_values(const std::string& test, const std::vector<std::string>& settings, const Catalogue& catalogue) {
  CaseFile given = CaseFile::empty();
  given.override_with("test=" + test, "riedel reproduce:");
  for (const std::string& setting : settings) given.override_with(setting, "riedel reproduce:");
  return element_case(given, catalogue).values;
}

ElementCurve element_curve(const Values& values, const Catalogue& catalogue) {
  return element_driver(values).run(values, catalogue,
                                    {[](const ElementRow&, const LawPoint&) {}, [] { return false; }});
}

} // namespace

double critical_void_ratio(const Values& law, double pressure) {
  return law.number("e_c0") * std::exp(-std::pow(3.0 * pressure / law.number("h_s"), law.number("n")));
}

std::vector<FigurePart> element_figures(const Figures& figures, const Catalogue& catalogue) {
  std::vector<FigurePart> found;
  for (const ElementFigure& each : all_element_figures()) {
    const auto wanted = [&](const auto& part) { return figures.contains(std::get<0>(part)); };
    if (std::ranges::none_of(each.parts, wanted)) continue;
    std::vector<NamedCurve> curves;
    for (const std::string& void_ratio : loose_to_dense) {
      std::vector<std::string> settings = each.settings;
      settings.push_back("specimen.void_ratio=" + void_ratio);
      curves.push_back(
          {"e₀ = " + void_ratio, element_curve(element_values(each.test, settings, catalogue), catalogue)});
    }
    const std::vector<ElementPlot> plots = element_plots(curves, std::nullopt, each.subject);
    for (const auto& [figure, name, file] : each.parts)
      if (figures.contains(figure))
        found.push_back({figure, name, "Figure " + name, std::ranges::find(plots, file, &ElementPlot::file)->plot});
  }
  std::ranges::stable_sort(found, {}, &FigurePart::name);
  return found;
}

CriticalState triaxial_end(const Catalogue& catalogue) {
  CriticalState end;
  for (const std::string& void_ratio : loose_to_dense) {
    const Values values =
        element_values("triaxial", {"specimen.void_ratio=" + void_ratio, "loading.final_strain=0.7"}, catalogue);
    const ElementRow last = element_curve(values, catalogue).rows.back();
    end.angle.push_back(last.phi_mob);
    end.void_ratio.push_back(last.void_ratio);
    const double P = last.sigma[0] + last.sigma[1] + last.sigma[2];
    end.expected_void_ratio = critical_void_ratio(values.section("material"), P / 3.0);
  }
  return end;
}

} // namespace riedel
