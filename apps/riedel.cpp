/// riedel: the program. Finds the sub-command, runs it and converts errors into exit codes.
#include "apps/command_help.hpp"
#include "apps/commands.hpp"
#include "apps/completion.hpp"
#include "apps/manual.hpp"
#include "apps/standard_streams.hpp"
#include "core/base/error.hpp"
#include "core/base/suggestion.hpp"
#include "core/io/messages.hpp"
#include "core/run/failure.hpp"

#include <iostream>
#include <new>
#include <system_error>

namespace {

using namespace riedel;

int print(const std::string& text) {
  std::cout << text;
  return 0;
}

/// Answers an option given before any command, which concerns the program itself.
int answer(const std::vector<std::string>& words) {
  const std::string& first = words.front();
  if (first == "--man") return print(manual_page(commands(), day_of_build()));
  if (first == "--completion") {
    if (words.size() != 2) throw InputError("--completion needs the name of a shell: bash or zsh");
    return print(completion(words[1], commands()));
  }
  const std::vector<std::string> known{"--help", "--version", "--man", "--completion"};
  for (const Command& command : commands())
    for (const Option& option : command.options)
      if (first == "--" + option.name)
        throw InputError(first + ": a command comes before its options, such as 'riedel " + command.name +
                         "'; see 'riedel --help'");
  throw InputError("unknown option " + first + did_you_mean(first, known) + "; see 'riedel --help'");
}

int run(std::vector<std::string> words) {
  if (words.empty()) throw InputError("no command given; see 'riedel --help'");
  if (words.front() == "--help" || words.front() == "-h" || words.front() == "help") {
    words.erase(words.begin());
    if (words.empty() || words.front() == "help") return print(help(commands()));
    words.emplace_back("--help");
  }
  if (words.front() == "--version" || words.front() == "-v" || words.front() == "version")
    return print(version() + "\n");
  if (words.front().starts_with('-')) return answer(words);
  const Command& command = find_command(commands(), words.front());
  const Arguments arguments = parse(command, {words.begin() + 1, words.end()}, commands());
  if (arguments.has("help")) return print(help(command, arguments));
  if (arguments.has("version")) return print(version() + "\n");
  return command.run(arguments);
}

int failed(std::string_view text, int code) {
  print_error(text);
  return code;
}

} // namespace

int main(int argc, char** argv) {
  secure_standard_streams();
  try {
    const int code = run({argv + 1, argv + argc});
    if (!flush_standard_output()) throw RunError("cannot write to standard output");
    return code;
  } catch (const InputError& error) { return failed(error.what(), 2); } catch (const RunError& error) {
    return failed(error.what(), 3);
  } catch (const PluginError& error) { return failed(error.what(), 4); } catch (const std::bad_alloc& error) {
    return failed(reason_of(error), 3);
  } catch (const std::system_error& error) { return failed(error.what(), 3); } catch (const std::exception& error) {
    return failed(std::string("internal: ") + error.what(), 1);
  }
}
