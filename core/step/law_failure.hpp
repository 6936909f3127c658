/// The error message of a run whose law fails at a point.
#pragma once

#include "core/step/state.hpp"

#include <numbers>

namespace riedel {

/// Stress and state of a point, for messages.
template <int Dim>
std::string condition_of(const Body<Dim>& body, Index p) {
  std::string text = "stress (";
  for (int c = 0; c < 6; ++c) // Mandel's shear components are √2 times the tensor's
    text += (c ? ", " : "") + short_text(body.points.stress[c][p] * (c < 3 ? 1.0 : std::numbers::sqrt2 / 2));
  text += ") Pa";
  int column = 0;
  for (const StateVariable& variable : body.material->states()) {
    text += ", " + variable.name;
    for (int c = 0; c < variable.components; ++c) text += " " + short_text(body.points.state[column++][p]);
  }
  return text;
}

template <int Dim>
[[noreturn]] void report_failure(const State<Dim>& state, const Body<Dim>& body, const MaterialReport& report) {
  const Index p = report.first_failure;
  std::string where;
  for (int a = 0; a < Dim; ++a) where += (a ? ", " : "") + exact_text(body.points.position[a][p]);
  throw RunError("the law failed at " + std::to_string(report.failures) + " point(s) of '" + body.name +
                 "', first at point " + std::to_string(body.points.id[p]) + " at (" + where +
                 ") m: " + std::string(report.reason) + "; " + condition_of(body, p) + "; step " +
                 std::to_string(state.step) + ", time " + exact_text(state.time) + " s");
}

/// Runs `work`; an exception from a body's law ends the run like a failure of the law, with body, step and time.
template <int Dim, class Work>
auto watched(const State<Dim>& state, const Body<Dim>& body, const Work& work) {
  const auto failure = [&](const std::string& why) {
    return RunError("the law of '" + body.name + "' failed: " + why + "; step " + std::to_string(state.step) +
                    ", time " + exact_text(state.time) + " s");
  };
  try {
    return work();
  } catch (const std::exception& error) { throw failure(error.what()); } catch (...) {
    throw failure("it threw an exception of an unknown type");
  }
}

} // namespace riedel
