#include "materials/umat_library.hpp"

#include "core/base/error.hpp"
#include "materials/umat_services.hpp"

#include <algorithm>
#include <csetjmp>
#include <cstdlib>
#include <dlfcn.h>
#include <unistd.h>

namespace riedel {

namespace {

/// CMNAME: 80 characters, filled up with blanks.
std::array<char, 80> padded(const std::string& name) {
  std::array<char, 80> text;
  text.fill(' ');
  std::copy_n(name.begin(), std::min(name.size(), text.size()), text.begin());
  return text;
}

/// What a UMAT may write that nobody reads here, and the numbers that never change.
struct Unused {
  double sse = 0, spd = 0, scd = 0, rpl = 0, drpldt = 0, temp = 0, dtemp = 0, predef = 0;
  std::array<double, 6> ddsddt{}, drplde{};
  std::array<double, 3> coords{};
  int ndi = 3, nshr = 3, ntens = 6, one = 1;
};

/// Comes back early when the subroutine calls XIT, over its frames, without running them to their ends.
template <class Call>
UmatEnd guarded(const Call& call) {
  std::jmp_buf here;
  way_out_of_umat() = &here;
  UmatEnd end = UmatEnd::xit;
  if (setjmp(here) == 0) { // NOLINT: the only way out of Fortran
    try {
      call();
      end = UmatEnd::returned;
    } catch (...) { end = UmatEnd::threw; }
  }
  way_out_of_umat() = nullptr;
  return end;
}

} // namespace

UmatLibrary::UmatLibrary(std::filesystem::path path, std::string symbol, bool thread_safe)
    : path_(std::move(path)), symbol_(std::move(symbol)), thread_safe_(thread_safe) {
  if (!std::filesystem::is_regular_file(path_)) throw PluginError("UMAT " + path_.string() + ": there is no such file");
  free_.push_back(loaded(std::filesystem::absolute(path_)));
}

UmatFunction UmatLibrary::loaded(const std::filesystem::path& path) const {
  void* const library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) throw PluginError("UMAT " + path_.string() + ": cannot be loaded: " + dlerror());
  void* const function = dlsym(library, symbol_.c_str());
  if (function == nullptr)
    throw PluginError("UMAT " + path_.string() + ": has no '" + symbol_ +
                      "' (gfortran and ifx on Linux name it umat_)");
  return reinterpret_cast<UmatFunction>(function);
}

UmatFunction UmatLibrary::copy() const {
  std::string name = (std::filesystem::temp_directory_path() / "riedel-umat-XXXXXX").string();
  const int file = mkstemp(name.data());
  if (file < 0) throw PluginError("UMAT " + path_.string() + ": no place for a copy in " + name);
  close(file);
  std::error_code error;
  std::filesystem::copy_file(path_, name, std::filesystem::copy_options::overwrite_existing, error);
  if (error) throw PluginError("UMAT " + path_.string() + ": cannot be copied to " + name + ": " + error.message());
  const UmatFunction function = loaded(name);
  std::filesystem::remove(name, error); // the loaded library needs its name no more
  return function;
}

UmatLibrary::Lease UmatLibrary::lease() {
  const std::scoped_lock lock(mutex_);
  if (thread_safe_) return {*this, free_.front()};
  if (free_.empty()) free_.push_back(copy());
  const UmatFunction function = free_.back();
  free_.pop_back();
  return {*this, function};
}

void UmatLibrary::give_back(UmatFunction function) {
  if (thread_safe_) return;
  const std::scoped_lock lock(mutex_);
  free_.push_back(function);
}

UmatEnd UmatLibrary::Lease::run(UmatCall& c, const std::vector<double>& parameters, int states,
                                const std::string& name) const {
  const std::array<char, 80> cmname = padded(name);
  const int count = static_cast<int>(parameters.size());
  Unused u;
  return guarded([&] {
    function_(c.stress.data(), c.state, c.stiffness.data(), &u.sse, &u.spd, &u.scd, &u.rpl, u.ddsddt.data(),
              u.drplde.data(), &u.drpldt, c.strain.data(), c.strain_increment.data(), c.time.data(), &c.time_step,
              &u.temp, &u.dtemp, &u.predef, &c.field_increment, cmname.data(), &u.ndi, &u.nshr, &u.ntens, &states,
              parameters.data(), &count, u.coords.data(), c.rotation.data(), &c.time_step_factor, &c.length,
              c.motion_before.data(), c.motion_after.data(), &c.point, &u.one, &u.one, &u.one, &u.one, &c.increment,
              cmname.size());
  });
}

} // namespace riedel
