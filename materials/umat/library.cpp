#include "materials/umat/library.hpp"

#include "core/base/error.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <unistd.h>

namespace riedel {

namespace {

/// CMNAME: 80 characters, padded with blanks.
std::array<char, 80> padded(const std::string& name) {
  std::array<char, 80> text;
  text.fill(' ');
  std::copy_n(name.begin(), std::min(name.size(), text.size()), text.begin());
  return text;
}

/// Arguments that a UMAT may write but nobody reads here, and constant numbers.
struct Unused {
  double sse = 0, spd = 0, scd = 0, rpl = 0, drpldt = 0, temp = 0, dtemp = 0, predef = 0;
  std::array<double, 6> ddsddt{}, drplde{};
  std::array<double, 3> coords{};
  int ndi = 3, nshr = 3, ntens = 6, one = 1;
};

} // namespace

UmatLibrary::UmatLibrary(std::filesystem::path path, std::string symbol, bool thread_safe)
    : path_(std::move(path)), symbol_(std::move(symbol)), thread_safe_(thread_safe) {
  if (!std::filesystem::is_regular_file(path_)) throw PluginError("UMAT " + path_.string() + ": there is no such file");
  free_.push_back(loaded(std::filesystem::absolute(path_)));
  catch_crashes_of_umats();
}

UmatFunction UmatLibrary::loaded(const std::filesystem::path& path) const {
  const Undisturbed process;
  void* const library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) throw PluginError("UMAT " + path_.string() + ": cannot be loaded: " + dlerror());
  void* const function = dlsym(library, symbol_.c_str());
  if (function == nullptr)
    throw PluginError("UMAT " + path_.string() + ": has no '" + symbol_ +
                      "' (gfortran and ifx on Linux name it umat_)");
  return reinterpret_cast<UmatFunction>(function);
}

UmatFunction UmatLibrary::copy() const {
  std::error_code error;
  std::filesystem::path folder = std::filesystem::temp_directory_path(error);
  if (error) folder = std::filesystem::current_path(error);
  std::string name = (folder / "riedel-umat-XXXXXX").string();
  const int file = mkstemp(name.data());
  if (file < 0) throw PluginError(folder.string() + " takes no copy: " + std::strerror(errno));
  close(file);
  std::filesystem::copy_file(path_, name, std::filesystem::copy_options::overwrite_existing, error);
  const std::string why = error ? folder.string() + " takes no copy: " + error.message() : "";
  try {
    if (!why.empty()) throw PluginError(why);
    const UmatFunction function = loaded(name);
    std::filesystem::remove(name, error); // the loaded library no longer needs its file
    return function;
  } catch (...) {
    std::filesystem::remove(name, error);
    throw;
  }
}

/// If no copy can be made, threads take turns with the existing ones, which is slow and gives a warning.
void UmatLibrary::add_copy() {
  try {
    free_.push_back(copy());
  } catch (const std::exception& error) {
    takes_turns_ = true;
    std::fprintf(stderr,
                 "riedel: warning: UMAT %s: there is no copy for another thread, so threads wait for each other "
                 "(%s); set TMPDIR to a folder with room, or material.thread_safe = true if threads may share it\n",
                 path_.c_str(), error.what());
  }
}

UmatLibrary::Lease UmatLibrary::lease() {
  std::unique_lock lock(mutex_);
  if (thread_safe_) return {*this, free_.front()};
  if (free_.empty() && !takes_turns_) add_copy();
  given_back_.wait(lock, [&] { return !free_.empty(); });
  const UmatFunction function = free_.back();
  free_.pop_back();
  return {*this, function};
}

void UmatLibrary::give_back(UmatFunction function) {
  if (thread_safe_) return;
  const std::scoped_lock lock(mutex_);
  free_.push_back(function);
  given_back_.notify_one();
}

std::string UmatLibrary::account_of(const UmatOutcome& outcome) const {
  const std::string umat = "the UMAT " + path_.string();
  if (outcome.end == UmatEnd::ended)
    return umat + " ended the program (STOP or exit, code " + std::to_string(outcome.code) + ")";
  return umat + " crashed: signal " + std::to_string(outcome.code) + " (" + strsignal(outcome.code) + ")";
}

UmatOutcome UmatLibrary::Lease::run(UmatCall& c, const std::vector<double>& parameters, int states,
                                    const std::string& name) const {
  const std::array<char, 80> cmname = padded(name);
  const int count = static_cast<int>(parameters.size());
  Unused u;
  return guarded_umat([&] {
    function_(c.stress.data(), c.state, c.stiffness.data(), &u.sse, &u.spd, &u.scd, &u.rpl, u.ddsddt.data(),
              u.drplde.data(), &u.drpldt, c.strain.data(), c.strain_increment.data(), c.time.data(), &c.time_step,
              &u.temp, &u.dtemp, &u.predef, &c.field_increment, cmname.data(), &u.ndi, &u.nshr, &u.ntens, &states,
              parameters.data(), &count, u.coords.data(), c.rotation.data(), &c.time_step_factor, &c.length,
              c.motion_before.data(), c.motion_after.data(), &c.point, &u.one, &u.one, &u.one, &c.stage, &c.increment,
              cmname.size());
  });
}

} // namespace riedel
