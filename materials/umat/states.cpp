#include "materials/umat/states.hpp"

#include "core/base/error.hpp"
#include "materials/umat/services.hpp"

#include <sstream>

namespace riedel {

UmatStates::UmatStates(const std::string& names, const std::vector<double>& start, double stress_unit) {
  std::istringstream words(names);
  for (std::string word; std::getline(words, word, ',');) declare(word, stress_unit);
  declared_ = variables_.size();
  while (factors_.size() < start.size()) { // the rest is numbered
    variables_.push_back({"state_" + std::to_string(factors_.size() + 1), "-", "STATEV of the UMAT"});
    factors_.push_back(1.0);
  }
  if (start.size() != factors_.size() && !start.empty())
    throw InputError("umat: state has " + std::to_string(start.size()) + " numbers, state_names stand for " +
                     std::to_string(factors_.size()));
  if (factors_.size() > maximum)
    throw InputError("umat: " + std::to_string(factors_.size()) +
                     " state variables are too many; allowed: " + std::to_string(maximum));
  start_ = start;
  start_.resize(factors_.size(), 0.0);
  for (std::size_t s = 0; s < start_.size(); ++s) start_[s] /= factors_[s];
  variables_.push_back({"umat_strain", "-", "STRAN, the total strain that rotates with the material", 6});
  start_.resize(start_.size() + 6, 0.0);
}

void UmatStates::declare(const std::string& given, double stress_unit) {
  std::string word = given;
  word.erase(0, word.find_first_not_of(' '));
  word.erase(word.find_last_not_of(' ') + 1);
  const std::size_t colon = word.find(':');
  const std::string kind = colon == std::string::npos ? "" : word.substr(colon + 1), label = word.substr(0, colon);
  const bool stress = kind == "stress";
  if (label.empty() || (!kind.empty() && !stress && kind != "strain"))
    throw InputError("umat: state_names: '" + word + "' is not a name; allowed: NAME, NAME:stress, NAME:strain");
  if (label == "void_ratio") void_ratio_ = static_cast<int>(factors_.size());
  const int components = kind.empty() ? 1 : 6;
  if (components == 6) tensors_.push_back({factors_.size(), stress ? 1 : 2});
  variables_.push_back({label, stress ? "Pa" : "-", "STATEV of the UMAT", components});
  for (int c = 0; c < components; ++c)
    factors_.push_back((c < 3 ? 1.0 : stress ? umat_stress_shear : umat_strain_shear) / (stress ? stress_unit : 1.0));
}

void UmatStates::rotate(double* statev, const double* Q) const {
  const int three = 3;
  for (const auto& [first, kind] : tensors_) {
    std::array<double, 6> turned{};
    rotsig_(statev + first, Q, turned.data(), &kind, &three, &three);
    std::ranges::copy(turned, statev + first);
  }
}

} // namespace riedel
