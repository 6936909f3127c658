#include "apps/manual.hpp"

#include "apps/biaxial/keys.hpp"
#include "apps/built_in.hpp"
#include "apps/command_help.hpp"
#include "core/case/case_text.hpp"
#include "core/case/key_tables.hpp"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>

namespace riedel {

namespace {

/// The first letter of a text in UTF-8, and how many bytes it takes.
std::pair<std::uint32_t, std::size_t> first_letter(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text[0]);
  const std::size_t bytes = lead < 0x80 ? 1 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
  std::uint32_t code = bytes == 1 ? lead : lead & (0x7FU >> bytes);
  for (std::size_t i = 1; i < bytes && i < text.size(); ++i)
    code = (code << 6U) | (static_cast<unsigned char>(text[i]) & 0x3FU);
  return {code, bytes};
}

std::string heading(const std::string& title) { return ".SH " + title + "\n"; }
std::string bold(const std::string& text) { return "\\fB" + roff(text) + "\\fR"; }
std::string italic(const std::string& text) { return "\\fI" + roff(text) + "\\fR"; }

/// A tagged paragraph; the tag is roff already.
std::string entry(const std::string& tag, const std::string& text) { return ".TP\n" + tag + "\n" + roff(text) + "\n"; }

std::string meanings(const std::vector<Meaning>& table) {
  std::string text;
  for (const Meaning& each : table) text += entry(bold(each.name), each.text);
  return text;
}

std::string options(const Options& all) {
  std::string text;
  for (const Option& option : all) {
    const char letter = letter_of(option.name);
    text += entry((letter == 0 ? "" : bold(std::string{'-', letter}) + ", ") + bold("--" + option.name) +
                      (option.value.empty() ? "" : " " + italic(option.value)),
                  option.doc);
  }
  return text;
}

std::string section_on(const Command& command) {
  return ".SS " + roff("riedel " + command.name + " " + command.usage) + "\n" + roff(command.summary) + "\n" +
         options(command.options);
}

std::string value_text(const Key& key) {
  const bool number = !key.unit.empty() && key.unit != "-" && !std::holds_alternative<std::string>(key.default_value);
  return toml_text(key.default_value) + (number ? " " + key.unit : "");
}

std::string keys(const Catalogue& catalogue) {
  std::string text =
      roff("Keys of a biaxial case, as --set takes them, with their defaults. 'riedel element TEST --help' shows "
           "those of an element test, 'riedel list NAME' the parameters of a law or a scheme.") +
      "\n";
  for (const Key& key : biaxial_keys(catalogue, paper_model)) {
    const std::string range = allowed(key);
    text += entry(bold(key.name) + " = " + roff(value_text(key)), key.doc + (range.empty() ? "" : "; " + range));
  }
  return text;
}

std::string entries(const std::string& title, const auto& registry) {
  std::string text = ".SS " + title + "\n";
  for (const auto& each : registry.entries()) text += entry(bold(each.description.name), each.description.summary);
  return text;
}

} // namespace

std::string roff(std::string_view text) {
  std::string out;
  if (text.starts_with('.') || text.starts_with('\'')) out = "\\&";
  while (!text.empty()) {
    const auto [code, bytes] = first_letter(text);
    if (code >= 0x80) {
      char escaped[16];
      std::snprintf(escaped, sizeof escaped, "\\[u%04X]", static_cast<unsigned>(code));
      out += escaped;
    } else if (code == '\\') {
      out += "\\e";
    } else if (code == '-') {
      out += "\\-";
    } else {
      out += code == '\n' ? ' ' : static_cast<char>(code);
    }
    text.remove_prefix(std::min(bytes, text.size()));
  }
  return out;
}

std::string day_of_build() {
  const char* const epoch = std::getenv("SOURCE_DATE_EPOCH");
  const std::time_t time = epoch == nullptr ? std::time(nullptr) : static_cast<std::time_t>(std::atoll(epoch));
  char day[16];
  std::strftime(day, sizeof day, "%Y-%m-%d", std::gmtime(&time));
  return day;
}

std::string manual_page(std::span<const Command> commands, const std::string& day) {
  const Catalogue catalogue = full_catalogue();
  std::string text = ".TH RIEDEL 1 \"" + day + "\" \"" + roff(version()) + "\" \"User Commands\"\n" + heading("NAME") +
                     roff("riedel") + " \\- " + roff("material point method for shear localisation in sand") + "\n" +
                     heading("SYNOPSIS");
  for (const Command& command : commands)
    text += (&command == commands.data() ? "" : ".br\n") + bold("riedel " + command.name) + " " + roff(command.usage) +
            "\n";
  text +=
      heading("DESCRIPTION") +
      roff("Runs a specimen of sand, or one element of it, under a choice of interpolation schemes and constitutive "
           "laws, and measures the resulting shear bands. A case is a file of keys in TOML; every key has a default, "
           "the value of Krzyżanowski, Wójcik and Tejchman (2020), so that a command without a case file runs the "
           "paper's case.") +
      "\n" + heading("COMMANDS");
  for (const Command& command : commands) text += section_on(command);
  text += heading("OPTIONS") +
          options({{"help", "",
                    "for every command: print its options and keys, for the test, law and scheme named "
                    "beside it"},
                   {"version", "", "print the version"},
                   {"man", "", "print this page; for the program itself"},
                   {"completion", "SHELL", "print the completion for bash or zsh; for the program itself"}});
  text += heading("KEYS") + keys(catalogue) + entries("Schemes", catalogue.in_2d.schemes) +
          entries("Laws", catalogue.materials);
  text += heading("FILES") + meanings(result_files()) + heading("EXIT STATUS") + meanings(exit_codes()) +
          heading("ENVIRONMENT") + meanings(environment_variables()) + heading("EXAMPLES") + meanings(example_lines());
  return text + heading("SEE ALSO") +
         roff("paraview(1), cmake(1); the folder docs of the source: docs/input.md lists every key, docs/howto has "
              "instructions.") +
         "\n";
}

} // namespace riedel
