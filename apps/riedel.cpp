/// riedel: the program. Finds the sub-command, runs it and turns what went wrong into an exit code.
#include "apps/commands.hpp"
#include "apps/messages.hpp"
#include "core/base/error.hpp"

#include <iostream>

namespace {

using namespace riedel;

int run(const std::vector<std::string>& words) {
  if (words.empty()) throw InputError("no command given; see 'riedel --help'");
  if (words.front() == "--help" || words.front() == "-h" || words.front() == "help") {
    std::cout << (words.size() > 1 ? help(find_command(commands(), words[1])) : help(commands()));
    return 0;
  }
  if (words.front() == "--version" || words.front() == "version") {
    std::cout << version() << '\n';
    return 0;
  }
  const Command& command = find_command(commands(), words.front());
  const Arguments arguments = parse(command, {words.begin() + 1, words.end()});
  if (!arguments.has("help")) return command.run(arguments);
  std::cout << help(command);
  return 0;
}

int failed(std::string_view text, int code) {
  print_error(text);
  return code;
}

} // namespace

int main(int argc, char** argv) {
  try {
    const int code = run({argv + 1, argv + argc});
    if (!std::cout.flush()) throw RunError("cannot write to standard output");
    return code;
  } catch (const InputError& error) { return failed(error.what(), 2); } catch (const RunError& error) {
    return failed(error.what(), 3);
  } catch (const PluginError& error) { return failed(error.what(), 4); } catch (const std::exception& error) {
    return failed(std::string("internal: ") + error.what(), 1);
  }
}
