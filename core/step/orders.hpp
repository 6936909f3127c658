/// The orders of a step and their names.
#pragma once

#include "core/step/musl.hpp"
#include "core/step/usf.hpp"
#include "core/step/usl.hpp"

namespace riedel {

template <int Dim>
struct StepOrder {
  const char* name;
  StepFunction<Dim> step;
};

template <int Dim>
constexpr std::array<StepOrder<Dim>, 3> orders_of_step{
    {{"musl", musl_step<Dim>}, {"usl", usl_step<Dim>}, {"usf", usf_step<Dim>}}};

} // namespace riedel
