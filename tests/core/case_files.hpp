/// Cases of a few keys, from files and settings.
#pragma once

#include "core/base/error.hpp"
#include "core/case/case_file.hpp"
#include "temporary_folder.hpp"

#include <gmock/gmock.h>

namespace riedel::test {

inline Keys keys() {
  return {{"scheme", "gimp", "", {}, "scheme", {"linear", "gimp", "cpdi"}},
          {"specimen.width", 0.04, "m", more_than(0.0), "width"},
          {"specimen.height", 0.14, "m", more_than(0.0), "height"},
          {"specimen.void_ratio", 0.55, "-", more_than(0.0), "void ratio"},
          {"grid.cells", std::vector<std::int64_t>{24, 84}, "-", at_least(1.0), "cells"},
          {"imperfection.size", std::vector<double>{5e-3, 5e-3}, "m", at_least(0.0), "size"},
          {"material.phi_c", 30.0, "deg", within(0.0, 90.0), "critical angle"},
          {"nonlocal.length", 1.5e-3, "m", at_least(0.0), "length"},
          {"time.step", "auto", "s", more_than(0.0), "step", {"auto"}},
          {"output.vtk", true, "", {}, "write"}};
}

class CaseFiles : public testing::Test {
protected:
  [[nodiscard]] std::string path() const { return (folder_ / "case.toml").string(); }
  [[nodiscard]] CaseFile file(std::string_view text) const { return CaseFile::read(folder_.file("case.toml", text)); }
  static std::string errors(const CaseFile& given) {
    try {
      (void)given.validate(keys());
    } catch (const InputError& error) { return error.what(); }
    return "no error";
  }
  [[nodiscard]] std::string errors(std::string_view text) const { return errors(file(text)); }
  static std::string syntax_error(std::string_view text) {
    try {
      (void)CaseFile::from_text(text, "case.toml");
    } catch (const InputError& error) { return error.what(); }
    return "no error";
  }
  static CaseFile with(const std::vector<std::string>& settings) {
    CaseFile given = CaseFile::empty();
    for (const std::string& setting : settings) given.override_with(setting);
    return given;
  }
  static std::string setting_error(const std::string& setting) {
    try {
      return errors(with({setting}));
    } catch (const InputError& error) { return error.what(); }
  }

private:
  TemporaryFolder folder_;
};

} // namespace riedel::test
