#include "apps/bench/options.hpp"

#include "apps/built_in.hpp"
#include "core/case/transfer_keys.hpp"
#include "core/io/units.hpp"

#include <algorithm>
#include <charconv>

namespace riedel {

namespace {

using Texts = std::vector<std::string>;

const Options& choices() {
  static const Catalogue catalogue = full_catalogue();
  static const Options all{
      {"scheme", "A,B", "interpolation schemes; default: gimp", true, catalogue.in_2d.schemes.names()},
      {"material", "A,B", "laws; default: gudehus_bauer", true, catalogue.materials.names()},
      {"dimension", "2,3", "default: 2", true, {"2", "3"}},
      {"points", "N,M", "material points, rounded to whole cells; default: 2e3,1e4,1e5,1e6"},
      {"per-cell", "N", "points per cell along each direction; default: 2"},
      {"order", "A,B", "of the step: musl, usl, usf; default: musl", true, step_orders()},
      {"transfer", "A,B", "of velocities: flip, apic, tpic, xpic; default: flip", true,
       catalogue.in_2d.transfers.names()},
      {"length", "A,B", "l_c in m, or with a unit: 1.5mm; 0 is local; default: 0"},
      {"averager", "A,B", "default: gauss", true, catalogue.in_2d.averagers.names()},
      {"search", "A,B", "for neighbours; default: " + catalogue.in_2d.searches.names().front(), true,
       catalogue.in_2d.searches.names()},
      {"filter", "N,M", "steps from one filtering of the stresses to the next, 20 in a biaxial test; default: 0, none"},
      {"stencils", "A,B", "kept for a step, evaluated in blocks, or auto; default: auto", true, stencil_memory()},
      {"threads", "N,M", "default: 1"},
  };
  return all;
}

[[noreturn]] void refuse(const std::string& option, const std::string& given, const std::string& why) {
  throw InputError("--" + option + " " + given + ": " + why);
}

/// A number without a unit; 1e5 counts as an integer.
double number(const std::string& option, const std::string& text, double minimum, double maximum, bool whole) {
  double x = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), x);
  const bool read = error == std::errc{} && end == text.data() + text.size();
  if (!read || !(x >= minimum && x <= maximum) || (whole && x != std::floor(x)))
    refuse(option, text,
           std::string("allowed: ") + (whole ? "an integer" : "a number") + " in [" + short_text(minimum, 6) + ", " +
               short_text(maximum, 6) + "]");
  return x;
}

std::vector<int> integers(const Arguments& arguments, const std::string& option, const Texts& otherwise, int minimum,
                          int maximum) {
  std::vector<int> all;
  for (const std::string& text : arguments.list(option, otherwise))
    all.push_back(static_cast<int>(number(option, text, minimum, maximum, true)));
  return all;
}

/// Metres, with a unit or without.
double length(const std::string& text) {
  const bool plain = text.find_first_not_of("0123456789.+-eE") == std::string::npos;
  double x = 0.0;
  if (plain) {
    x = number("length", text, 0.0, 1e3, false);
  } else {
    try {
      x = read_quantity(text, "m");
    } catch (const InputError& error) { refuse("length", text, error.what()); }
  }
  if (!(x >= 0.0)) refuse("length", text, "allowed: 0 (local) or more");
  return x;
}

bool averages(const std::string& material, const Catalogue& catalogue) {
  const auto& entry = catalogue.materials.find(material);
  return !entry.make(Values(entry.description.parameters))->nonlocal_variables().empty();
}

/// Every case of `cases` once with every value.
template <class T, class Member>
std::vector<BenchCase> vary(const std::vector<BenchCase>& cases, Member member, const std::vector<T>& values) {
  std::vector<BenchCase> all;
  for (const BenchCase& each : cases)
    for (const T& value : values) {
      all.push_back(each);
      all.back().*member = value;
    }
  return all;
}

} // namespace

Options bench_options() {
  Options options = choices();
  options.push_back({"repeats", "N", "number of repeats for median, least and most; default: 5"});
  options.push_back({"seconds", "T", "minimum duration of a repeat; default: 0.2"});
  options.push_back({"json", "FILE", "also write the figures to this file"});
  options.push_back(plugin_option());
  options.push_back({"peers", "", "the cases in which other programs were measured, beside their figures"});
  options.push_back({"machine", "", "what this machine can do: bandwidth, peak, exp, pow, law, bare kernel"});
  return options;
}

std::vector<BenchCase> bench_cases(const Arguments& arguments, const Catalogue& catalogue) {
  const BenchCase otherwise;
  std::vector<double> lengths;
  for (const std::string& text : arguments.list("length", {"0"})) lengths.push_back(length(text));
  std::vector<BenchCase> all{otherwise};
  all = vary(all, &BenchCase::material, arguments.names("material", {otherwise.material}, catalogue.materials.names()));
  all = vary(all, &BenchCase::dimension, integers(arguments, "dimension", {"2"}, 2, 3));
  all = vary(all, &BenchCase::per_cell, integers(arguments, "per-cell", {"2"}, 1, 8));
  all = vary(all, &BenchCase::length, lengths);
  const Texts averagers = arguments.names("averager", {otherwise.averager}, catalogue.in_2d.averagers.names());
  const Texts searches =
      arguments.names("search", {catalogue.in_2d.searches.names().front()}, catalogue.in_2d.searches.names());
  all = vary(vary(all, &BenchCase::averager, averagers), &BenchCase::search, searches);
  all = vary(all, &BenchCase::order, arguments.names("order", {otherwise.order}, step_orders()));
  all = vary(all, &BenchCase::transfer,
             arguments.names("transfer", {otherwise.transfer}, catalogue.in_2d.transfers.names()));
  all = vary(all, &BenchCase::points, integers(arguments, "points", {"2e3", "1e4", "1e5", "1e6"}, 1, 100'000'000));
  all = vary(all, &BenchCase::scheme, arguments.names("scheme", {otherwise.scheme}, catalogue.in_2d.schemes.names()));
  all = vary(all, &BenchCase::filter, integers(arguments, "filter", {"0"}, 0, 1000));
  all = vary(all, &BenchCase::stencils, arguments.names("stencils", {otherwise.stencils}, stencil_memory()));
  all = vary(all, &BenchCase::threads, integers(arguments, "threads", {"1"}, 1, 1024));

  std::erase_if(all, [&](const BenchCase& c) {
    if (c.length == 0.0) return c.averager != averagers.front() || c.search != searches.front(); // local: once
    return !averages(c.material, catalogue);
  });
  if (all.empty()) throw InputError("--length: none of the laws named takes an average; 0 is local");
  return all;
}

BenchEffort bench_effort(const Arguments& arguments) {
  BenchEffort effort;
  if (const auto given = arguments.text("repeats"))
    effort.repeats = static_cast<int>(number("repeats", *given, 1, 1000, true));
  if (const auto given = arguments.text("seconds")) effort.seconds = number("seconds", *given, 1e-6, 3600, false);
  return effort;
}

void refuse_choices(const Arguments& arguments, const std::string& mode) {
  for (const Option& option : choices())
    if (arguments.has(option.name)) throw InputError("--" + option.name + ": --" + mode + " has cases of its own");
}

} // namespace riedel
