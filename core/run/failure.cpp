#include "core/run/failure.hpp"

#include "core/base/error.hpp"
#include "core/io/messages.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <new>
#include <system_error>

namespace riedel {

std::string reason_of(const std::exception& error) {
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr ||
      dynamic_cast<const std::length_error*>(&error) != nullptr)
    return std::string(reasons::no_memory) + "; fewer points, a shorter nonlocal.length or fewer --threads need less";
  return error.what();
}

bool lacked_space(std::string_view reason) {
  return std::ranges::any_of(std::array{ENOSPC, EDQUOT, EFBIG},
                             [&](int error) { return reason.find(std::strerror(error)) != std::string_view::npos; });
}

bool lacked_means(std::string_view reason) {
  const std::array means{reasons::no_memory, reasons::too_large, reasons::no_threads};
  return lacked_space(reason) ||
         std::ranges::any_of(means, [&](const char* text) { return reason.find(text) != std::string_view::npos; });
}

void rethrow_as_failure() {
  try {
    throw;
  } catch (const InputError&) { throw; } catch (const PluginError&) {
    throw;
  } catch (const RunError&) { throw; } catch (const std::exception& error) {
    throw RunError(reason_of(error));
  }
}

void try_to_write(const std::string& what, const std::function<void()>& write) {
  try {
    write();
  } catch (const std::exception& error) {
    print_warning(what + " could not be written: " + reason_of(error) + "; the other results are complete");
  }
}

} // namespace riedel
