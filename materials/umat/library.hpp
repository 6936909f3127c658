/// A user's subroutine UMAT, called as by Abaqus, in a shared library.
#pragma once

#include "core/base/undisturbed.hpp"
#include "materials/umat/guard.hpp"

#include <array>
#include <condition_variable>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace riedel {

/// Arguments in their order. Tensors: 11, 22, 33, 12, 13, 23, strains with engineering shear; matrices by columns. The
/// length of CMNAME is a hidden last argument, as passed by gfortran (8 and later) and ifx; C and C++ may leave it out.
using UmatFunction = void (*)(double* stress, double* statev, double* ddsdde, double* sse, double* spd, double* scd,
                              double* rpl, double* ddsddt, double* drplde, double* drpldt, const double* stran,
                              const double* dstran, const double* time, const double* dtime, const double* temp,
                              const double* dtemp, const double* predef, const double* dpred, const char* cmname,
                              const int* ndi, const int* nshr, const int* ntens, const int* nstatv, const double* props,
                              const int* nprops, const double* coords, const double* drot, double* pnewdt,
                              const double* celent, const double* dfgrd0, const double* dfgrd1, const int* noel,
                              const int* npt, const int* layer, const int* kspt, const int* kstep, const int* kinc,
                              std::size_t cmname_length);

/// Input and output of one call.
struct UmatCall {
  std::array<double, 6> stress{}, strain{}, strain_increment{};
  double* state = nullptr;
  std::array<double, 36> stiffness{}; ///< DDSDDE
  std::array<double, 2> time{};       ///< at the start: in the stage, in total [s]
  double time_step = 0.0;             ///< [s]
  double field_increment = 0.0;       ///< DPRED(1)
  std::array<double, 9> rotation{1, 0, 0, 0, 1, 0, 0, 0, 1};
  std::array<double, 9> motion_before{1, 0, 0, 0, 1, 0, 0, 0, 1}, motion_after{1, 0, 0, 0, 1, 0, 0, 0, 1};
  double length = 1.0;                     ///< CELENT [m]
  double time_step_factor = 1.0;           ///< PNEWDT
  int point = 1, increment = 1, stage = 1; ///< NOEL, KINC, KSTEP
};

/// The library, loaded once, or a copy of it for every simultaneous call: COMMON blocks and SAVE make one copy unsafe
/// for two threads. If no copy can be made, threads take turns.
class UmatLibrary {
public:
  /// @param symbol `umat_` from Fortran   @throws PluginError: no such file, not loadable, without the symbol
  UmatLibrary(std::filesystem::path path, std::string symbol, bool thread_safe);

  /// The right to call a copy. Changes by the UMAT to the processor's rounding and traps end with it.
  class Lease {
  public:
    Lease(UmatLibrary& owner, UmatFunction leased) : owner_(owner), function_(leased) {}
    ~Lease() { owner_.give_back(function_); }
    Lease(const Lease&) = delete;
    Lease& operator=(const Lease&) = delete;

    /// XIT, which ends Abaqus, ends the call; so do STOP, exit and a crash.
    UmatOutcome run(UmatCall& call, const std::vector<double>& parameters, int states, const std::string& name) const;

    [[nodiscard]] UmatFunction function() const { return function_; }

  private:
    UmatLibrary& owner_;
    UmatFunction function_;
    KeptArithmetic arithmetic_;
    UmatCallUnderWay under_way_;
  };
  /// Waits if there is one copy for all threads.
  Lease lease();
  /// "the UMAT FILE ended the program (STOP …)", for messages.
  [[nodiscard]] std::string account_of(const UmatOutcome& outcome) const;

private:
  UmatFunction loaded(const std::filesystem::path& path) const;
  UmatFunction copy() const;
  void add_copy();
  void give_back(UmatFunction function);

  std::filesystem::path path_;
  std::string symbol_;
  bool thread_safe_;
  bool takes_turns_ = false; ///< no more copies can be made
  std::mutex mutex_;
  std::condition_variable given_back_;
  std::vector<UmatFunction> free_; ///< copies not in use
};

} // namespace riedel
