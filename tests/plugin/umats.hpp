/// UMATs as a user runs them.
#pragma once

#include "core/io/table.hpp"
#include "plugin/plugins.hpp"

#include <gmock/gmock.h>

namespace riedel::test {

inline Words joined(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

inline Words set(std::initializer_list<std::string> settings) {
  Words words;
  for (const std::string& setting : settings) words.insert(words.end(), {"--set", setting});
  return words;
}

/// Settings of a law of a library.
inline Words umat_named(const std::string& file, const std::string& name, const std::string& parameters) {
  return set({"material.model=umat", "material.library=" + library(file), "material.name=\"" + name + "\"",
              "material.parameters=" + parameters});
}

/// A short element test without pictures.
inline Words element(const TemporaryFolder& folder, const std::string& test, const Words& law, const Words& more = {}) {
  const Words words{"element", test, "--out", (folder / "out").string(), "--force", "--set", "output.plots=false"};
  return joined(joined(words, law), more);
}

/// A very small biaxial test.
inline Words biaxial(const TemporaryFolder& folder, const Words& law, const Words& more = {}) {
  const Words tiny = set({"nonlocal.length=0", "grid.cells=[4,8]", "imperfection.size=[0,0]", "loading.speed=1",
                          "loading.final_strain=0.002", "output.plots=false"});
  return joined(coarse_case(folder / "out", joined(tiny, {"--force"})), joined(law, more));
}

/// The last σ1 of an element test, compression positive [kPa].
inline double last_stress(const TemporaryFolder& folder, const Words& words) {
  const Outcome outcome = run(folder, words);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  if (outcome.code != 0) return 0.0;
  return 1e-3 * read_table(folder / "out" / "element.csv")["sigma_1_Pa"].back();
}

/// An environment variable, for programs that start during its lifetime.
class Environment {
public:
  Environment(const char* name, const char* value) : name_(name) { ::setenv(name, value, 1); }
  ~Environment() { ::unsetenv(name_); }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

private:
  const char* name_;
};

} // namespace riedel::test
