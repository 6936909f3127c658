#include "core/run/run.hpp"

namespace riedel {

template <int Dim>
Run<Dim>::Run(Simulation<Dim>& simulation, Stepper stepper) : simulation_(simulation), stepper_(std::move(stepper)) {}

template <int Dim>
Run<Dim>& Run<Dim>::after_steps(std::int64_t steps, Action act) {
  monitors_.push_back({.steps = steps, .act = std::move(act)});
  return *this;
}

template <int Dim>
Run<Dim>& Run<Dim>::every(double interval, Measure measure, Action write) {
  monitors_.push_back({.steps = 1, .act = std::move(write), .measure = std::move(measure), .interval = interval});
  return *this;
}

template <int Dim>
Run<Dim>& Run<Dim>::every(double interval, Action write) {
  return every(
      interval, [this] { return simulation_.state().time; }, std::move(write));
}

template <int Dim>
Run<Dim>& Run<Dim>::until(std::string name, Condition reached) {
  stops_.push_back({std::move(name), std::move(reached)});
  return *this;
}

template <int Dim>
Run<Dim>& Run<Dim>::until(double time) {
  return until("time", [this, time] { return simulation_.state().time >= time; });
}

template <int Dim>
Run<Dim>& Run<Dim>::until_step(std::int64_t last) {
  return until("step", [this, last] { return step() >= last; });
}

template <int Dim>
void Run<Dim>::begin() {
  for (Monitor& each : monitors_)
    if (each.measure) write_if_due(each);
}

template <int Dim>
std::string Run<Dim>::go() {
  begin();
  for (;;) {
    if (const Stop* stop = reached_stop()) return stop->name;
    stepper_([this] { simulation_.step(); });
    ++steps_;
    for (Monitor& each : monitors_)
      if (each.measure)
        write_if_due(each);
      else if (steps_ % each.steps == 0)
        each.act();
  }
}

template <int Dim>
void Run<Dim>::finish() {
  for (Monitor& each : monitors_)
    if (each.measure && each.written != step()) {
      each.act();
      each.written = step();
    }
}

template <int Dim>
void Run<Dim>::write_if_due(Monitor& writer) {
  if (writer.written == step() || writer.measure() < writer.next) return;
  writer.act();
  writer.next += writer.interval;
  writer.written = step();
}

template <int Dim>
auto Run<Dim>::reached_stop() const -> const Stop* {
  for (const Stop& stop : stops_)
    if (stop.reached()) return &stop;
  return nullptr;
}

template class Run<2>;
template class Run<3>;

} // namespace riedel
