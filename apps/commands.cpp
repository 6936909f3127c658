#include "apps/commands.hpp"

namespace riedel {

const std::vector<Command>& commands() {
  static const std::vector<Command> all{biaxial_command(),   element_command(),   compare_command(), collect_command(),
                                        reproduce_command(), check_command(),     list_command(),    bench_command(),
                                        verify_command(),    umat_check_command()};
  return all;
}

} // namespace riedel
