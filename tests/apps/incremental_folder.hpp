/// Files of IncrementalDriver in a folder, and their import.
#pragma once

#include "apps/element/incremental/driver.hpp"
#include "apps/element/keys.hpp"
#include "apps/element/path.hpp"
#include "core/base/error.hpp"
#include "support/problems.hpp"
#include "temporary_folder.hpp"

namespace riedel::test {

class IncrementalFolder : public testing::Test {
protected:
  const std::string parameters_ = "gudehus_bauer\n9\n30 phi_c\n0. p_t\n190d3 h_s\n0.5\n0.51\n0.82\n1.3\n0.3\n1.0\n";

  void write(const std::string& test, double kPa = -1.0, const std::string& void_ratio = "0.6 e") const {
    folder_.file("parameters.inp", parameters_);
    std::string start = "6\n";
    for (int c = 0; c < 6; ++c) start += (c < 3 ? exact_text(kPa) : "0") + "\n";
    folder_.file("initialconditions.inp", start + "7\n0\n0\n0\n0\n0\n0\n" + void_ratio + "\n");
    folder_.file("test.inp", "output.txt\n" + test);
  }
  [[nodiscard]] CheckedCase imported() const {
    CaseFile given = import_incremental_driver(incremental_files({folder_.path().string()}), CaseFile::empty());
    given.override_with("test=path");
    return element_case(given, catalogue());
  }
  [[nodiscard]] std::string error(const std::string& test) const {
    write(test);
    try {
      (void)imported();
    } catch (const InputError& error) { return error.what(); }
    return "no error";
  }
  TemporaryFolder folder_;
};

inline std::vector<std::string> words(const PathLeg& leg) {
  std::vector<std::string> all;
  for (const Prescription& each : leg.prescriptions) {
    all.push_back(each.measure->name + "=" + short_text(*each.target));
    if (each.swing != 0.0) all.back() += "~" + short_text(each.swing) + "@" + short_text(each.phase);
  }
  return all;
}

} // namespace riedel::test
