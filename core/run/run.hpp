/// The loop of a run: steps until a stop condition is met, with monitors after steps and writers whenever they are due.
#pragma once

#include "core/step/simulation.hpp"

#include <string>

namespace riedel {

/// Runs a simulation, which must outlive it:
///
///     Run<2> run(simulation);
///     run.every(0.02, [&] { frames.write(snapshot(simulation)); }).until(1.0).go();
///
/// Monitors and writers act after a step, in the order in which they were added.
template <int Dim>
class Run {
public:
  using Action = std::function<void()>;
  using Measure = std::function<double()>;
  using Condition = std::function<bool()>;
  using Stepper = std::function<void(const Action& step)>; ///< runs one step, with a clock or a choice of threads

  explicit Run(Simulation<Dim>& simulation) : Run(simulation, [](const Action& step) { step(); }) {}
  Run(Simulation<Dim>& simulation, Stepper stepper);
  Run(const Run&) = delete; // its own stops refer to it
  Run& operator=(const Run&) = delete;

  /// A monitor, called after every `steps` steps.
  Run& after_steps(std::int64_t steps, Action act);
  /// A writer: called at the start, and whenever `measure` has reached the next multiple of `interval` after a step.
  Run& every(double interval, Measure measure, Action write);
  /// The same with time as the measure [s].
  Run& every(double interval, Action write);

  /// A stop condition. All are checked before a step, in the order of their addition. @param name returned by `go`
  Run& until(std::string name, Condition reached);
  Run& until(double time);            ///< [s]; called "time"
  Run& until_step(std::int64_t step); ///< counted from the simulation's own start; called "step"

  /// Does what is due before the first step; called by `go` unless done before. @throws whatever a writer throws
  void begin();
  /// Takes steps until a stop is reached. May be called again. @return the name of that stop
  /// @throws RunError from a step, or whatever a monitor or a writer throws
  std::string go();
  /// Calls the writers that have not written the present state.
  void finish();

private:
  struct Monitor {
    std::int64_t steps;
    Action act;
    Measure measure = {};
    double interval = 0.0, next = 0.0; ///< of a writer
    std::int64_t written = -1;         ///< step at which it last wrote
  };
  struct Stop {
    std::string name;
    Condition reached;
  };
  void write_if_due(Monitor& writer);
  [[nodiscard]] const Stop* reached_stop() const;
  [[nodiscard]] std::int64_t step() const { return simulation_.state().step; }

  Simulation<Dim>& simulation_;
  Stepper stepper_;
  std::vector<Monitor> monitors_;
  std::vector<Stop> stops_;
  std::int64_t steps_ = 0; ///< taken by this run
};

} // namespace riedel
