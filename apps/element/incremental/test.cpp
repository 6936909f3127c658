/// test.inp of IncrementalDriver: steps become stages of a path.
#include "apps/element/incremental/case.hpp"
#include "apps/element/incremental/stop.hpp"
#include "apps/element/incremental/variables.hpp"
#include "apps/element/path_keys.hpp"
#include "core/base/suggestion.hpp"
#include "core/case/case_text.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace riedel {

namespace {

const std::vector<std::string> spelled{
    "*LinearLoad", "*CirculatingLoad", "*DeformationGradient", "*OedometricE1", "*OedometricS1",
    "*TriaxialE1", "*TriaxialS1",      "*TriaxialUEq",         "*TriaxialUq",   "*PureRelaxation",
    "*PureCreep",  "*UndrainedCreep",  "*Repetition",          "*End"};

std::string small_letters(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::string first_word(const std::string& line) {
  std::string word;
  std::istringstream(line) >> word;
  return word;
}

/// A line with a keyword, and the condition after a question mark.
struct Keyword {
  std::string given, condition;
  [[nodiscard]] std::string plain() const { return small_letters(given); }
};
Keyword keyword_of(const std::string& line) {
  const std::size_t mark = std::min(line.find('?'), line.size());
  return {first_word(line.substr(0, mark)), mark == line.size() ? "" : line.substr(mark + 1)};
}

class Steps {
public:
  Steps(IncrementalCase& into, const std::filesystem::path& path) : into_(into), lines_(path) {}

  void read() {
    (void)lines_.line("the name of the output"); // not used: the output is output.txt in the results folder
    for (std::string line; lines_.next(line);) {
      const Keyword keyword = keyword_of(line);
      if (keyword.plain() == "*end") return;
      begin_stage(keyword);
      const std::string at = stage_prefix(stage_);
      if (keyword.plain() == "*repetition") {
        read_repetition(at);
      } else {
        read_step(keyword, at);
        if (!keyword.condition.empty()) {
          into_.set(lines_, at + "until", toml_text(incremental_stop(lines_, keyword.condition, into_.stress_unit)));
          time_known_ = false;
        }
      }
    }
  }

private:
  void begin_stage(const Keyword& keyword) {
    const std::string at = stage_prefix(++stage_);
    const bool starred = keyword.given.starts_with('*');
    into_.set(lines_, at + "name", toml_text(keyword.given.substr(starred ? 1 : 0)));
    into_.set(lines_, at + "relative", "true");
    into_.set(lines_, at + "spin", "false");
  }

  void read_repetition(const std::string& at) {
    constexpr std::int64_t max_steps = 1000, max_rounds = 1'000'000;
    const auto counts = lines_.numbers(2, "the number of steps and of repetitions");
    const std::int64_t steps = lines_.integer_of(counts[0], "a number of steps", 1, max_steps);
    rounds_ = lines_.integer_of(counts[1], "a number of repetitions", 1, max_rounds);
    into_.set(lines_, at + "repeat", std::to_string(rounds_));
    const double before = time_;
    phased_.clear();
    for (std::int64_t leg = 1; leg <= steps; ++leg) {
      const Keyword keyword = keyword_of(lines_.line("a step"));
      if (!keyword.condition.empty())
        lines_.refuse("conditions that end a step early ('?') are not supported in a *Repetition");
      read_step(keyword, leg_prefix(stage_, static_cast<int>(leg)));
    }
    if (rounds_ > 1) refuse_shifted_rounds(time_ - before);
    time_ = before + static_cast<double>(rounds_) * (time_ - before);
    rounds_ = 1;
  }

  /// IncrementalDriver counts time through all steps, so that a period that does not fit into a round begins at another
  /// phase in the next one.
  void refuse_shifted_rounds(double round) const {
    for (const double period : phased_)
      if (!fits(round, period))
        lines_.refuse("a *CirculatingLoad with a time of " + exact_text(period) + " in rounds of " + exact_text(round) +
                      " begins at another phase in each of them: not supported");
  }

  static bool fits(double time, double period) {
    const double rest = std::abs(std::remainder(time, period));
    return rest <= 1e-9 * std::max(time, period);
  }

  void read_step(const Keyword& keyword, const std::string& at) {
    const std::string plain = keyword.plain();
    const auto shorthand = std::ranges::find_if(incremental_shorthands(),
                                                [&](const IncrementalShorthand& s) { return plain == s.keyword; });
    if (plain != "*linearload" && plain != "*circulatingload" && plain != "*deformationgradient" &&
        shorthand == incremental_shorthands().end())
      refuse_keyword(keyword.given);
    const double duration = read_commons();
    into_.set(lines_, at + "duration", duration);
    if (plain == "*deformationgradient")
      read_deformation(at, duration);
    else if (plain == "*circulatingload")
      read_circulating(at, duration);
    else if (plain == "*linearload")
      read_linear(at);
    else
      take(at, incremental_variables().at(shorthand->variables), shorthand->is_stress, changed(*shorthand));
    time_ += duration;
  }

  std::array<double, 6> changed(const IncrementalShorthand& shorthand) {
    std::array<double, 6> change{};
    if (shorthand.changed >= 0) change[static_cast<std::size_t>(shorthand.changed)] = lines_.number("a change");
    return change;
  }

  [[noreturn]] void refuse_keyword(const std::string& keyword) const {
    std::string known;
    for (const std::string& name : spelled) known += (known.empty() ? "" : ", ") + name;
    lines_.refuse("the keyword '" + keyword + "' is not supported" + did_you_mean(keyword, spelled) +
                  "; known: " + known);
  }

  /// "1000 30 1.0: 10": increments, iterations and a time; after a colon the interval of rows, which is not used here;
  /// after a T the change of temperature. @return the time [s]
  double read_commons() {
    const std::string line = lines_.line("increments, iterations and a time");
    const std::size_t colon = std::min(line.find(':'), line.size());
    const auto numbers = lines_.numbers_in(line.substr(0, colon), 3, "increments, iterations and a time");
    constexpr std::int64_t maximum = std::numeric_limits<std::int32_t>::max();
    (void)lines_.integer_of(numbers[0], "a number of increments", 1, maximum);
    (void)lines_.integer_of(numbers[1], "a number of iterations", 0, maximum);
    if (colon < line.size())
      (void)lines_.integer_of(
          lines_.numbers_in(line.substr(colon + 1), 1, "the number of increments between rows").front(),
          "a number of increments between rows", -maximum, maximum);
    refuse_temperature(line);
    if (!(numbers[2] > 0.0)) lines_.refuse("a time of " + exact_text(numbers[2]) + "; allowed: more than 0");
    return numbers[2];
  }

  void refuse_temperature(const std::string& line) const {
    std::istringstream words(line);
    for (std::string word; words >> word;) {
      if (word == "T" && words >> word)
        if (lines_.numbers_in(word, 1, "a change of temperature").front() != 0.0)
          lines_.refuse("a change of temperature is not supported; only 0");
      if (word.starts_with('#') || word.starts_with('!') || word.starts_with('/')) return; // a comment
    }
  }

  const IncrementalVariables& read_variables() {
    const std::string word = first_word(lines_.line("the variables, such as *Cartesian"));
    const auto found = incremental_variables().find(small_letters(word));
    if (found == incremental_variables().end())
      lines_.refuse("the variables '" + word +
                    "' are not supported; known: *Cartesian, *Roscoe, *RoscoeIsomorph, *Rendulic");
    return found->second;
  }

  bool is_stress(double flag) const {
    if (flag != 0.0 && flag != 1.0) lines_.refuse("a condition begins with 0 (strain) or 1 (stress)");
    return flag == 1.0;
  }

  void read_linear(const std::string& at) {
    const IncrementalVariables& in = read_variables();
    std::array<bool, 6> stress{};
    std::array<double, 6> change{};
    for (std::size_t c = 0; c < 6; ++c) {
      const auto pair = lines_.numbers(2, "0 (strain) or 1 (stress), and a change");
      stress[c] = is_stress(pair[0]);
      change[c] = pair[1];
    }
    take(at, in, stress, change);
  }

  void take(const std::string& at, const IncrementalVariables& in, const std::array<bool, 6>& stress,
            const std::array<double, 6>& change) {
    for (std::size_t c = 0; c < 6; ++c)
      into_.set(lines_, at + in[c].name(stress[c]), in[c].factor(stress[c], into_.stress_unit) * change[c]);
  }
  /// Amplitude, phase [rad] and linear change of each component, one period in the step's time. IncrementalDriver's
  /// sine runs with the time of all steps.
  void read_circulating(const std::string& at, double period) {
    if (!time_known_)
      lines_.refuse("a *CirculatingLoad after a step that a condition ('?') may end early is not supported: its phase "
                    "counts from the time at its start");
    const IncrementalVariables& in = read_variables();
    const double shift = fits(time_, period) ? 0.0 : 2.0 * std::numbers::pi * std::fmod(time_, period) / period;
    for (const IncrementalPair& pair : in) {
      const auto row = lines_.numbers(4, "0 (strain) or 1 (stress), an amplitude, a phase and a change");
      const bool stress = is_stress(row[0]);
      const std::string key = at + pair.name(stress);
      into_.set(lines_, key, pair.factor(stress, into_.stress_unit) * row[3]);
      into_.set(lines_, swing_key(key), pair.factor(stress, into_.stress_unit) * row[1]);
      into_.set(lines_, phase_key(key), (row[2] + shift) * 180.0 / std::numbers::pi);
    }
    phased_.push_back(period);
  }

  /// F at the end of the step, in the order 11, 22, 33, 12, 21, 13, 31, 23, 32. IncrementalDriver goes there from the
  /// unit tensor at time 0, and changes F by as much again in each later step of this kind.
  void read_deformation(const std::string& at, double duration) {
    constexpr std::array<std::pair<int, int>, 9> order{
        {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 0}, {0, 2}, {2, 0}, {1, 2}, {2, 1}}};
    Eigen::Matrix3d F;
    for (const auto& [i, j] : order) F(i, j) = lines_.number("a component of the deformation gradient");
    if (!time_known_ || (rounds_ > 1))
      lines_.refuse("a *DeformationGradient in a *Repetition, or after a step that a condition may end early, is not "
                    "supported: it counts from the time at its start");
    const Eigen::Matrix3d I = Eigen::Matrix3d::Identity(), before = I + time_ / duration * (F - I);
    if (!(before.determinant() > 0.0) || !((before + F - I).determinant() > 0.0))
      lines_.refuse("a deformation gradient whose determinant is not positive");
    const Eigen::Matrix3d change = (before + F - I) * before.inverse();
    std::vector<double> by_rows;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) by_rows.push_back(change(i, j));
    into_.set(lines_, at + "deformation_gradient", toml_text(by_rows));
  }

  IncrementalCase& into_;
  InputLines lines_;
  int stage_ = 0;
  std::int64_t rounds_ = 1;    ///< of the present stage
  double time_ = 0.0;          ///< at the start of the step [s]
  bool time_known_ = true;     ///< no step before may have ended early
  std::vector<double> phased_; ///< periods in the present stage [s]
};

} // namespace

void read_incremental_test(IncrementalCase& into, const std::filesystem::path& path) { Steps(into, path).read(); }

} // namespace riedel
