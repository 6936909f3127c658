#include "apps/entry_text.hpp"

#include "core/case/key_tables.hpp"

namespace riedel {

namespace {

/// @param section of a case that holds the parameters; empty: there are none
std::string parameters_text(const Description& description, const std::string& section) {
  if (description.parameters.empty()) return "parameters: none\n";
  return "parameters, keys of [" + section + "]: name, default, what is allowed, what it is\n" +
         parameters_help(description.parameters);
}

std::string head(const Description& description, const std::string& kind, const std::string& key) {
  std::string text = description.name + ", " + kind + ": " + description.summary + "\n";
  if (has_source(description)) text += "source: " + description.source + "\n";
  return text + "in a case: --set " + key + "=" + description.name + "\n";
}

std::string states_text(const Material& law) {
  if (law.states().empty()) return "state variables: none beside the stress\n";
  std::string text = "state variables, carried by each point and written to the files for ParaView\n";
  for (const StateVariable& state : law.states()) {
    text += "    " + state.name + (state.unit.empty() || state.unit == "-" ? "" : " [" + state.unit + "]") + ": " +
            state.doc;
    text += state.components == 1 ? "\n" : "; " + std::to_string(state.components) + " components\n";
  }
  return text;
}

std::string averages_text(const Material& law) {
  std::string names;
  for (const std::string& name : law.nonlocal_variables()) names += (names.empty() ? "" : ", ") + name;
  if (names.empty()) return "averaged over nonlocal.length: nothing with these values; the law is local then\n";
  return "averaged over nonlocal.length (nonlocal.variable): " + names + "\n";
}

} // namespace

std::string brief_text(const Description& description) {
  std::string text = "  " + description.name + ": " + description.summary + "\n";
  if (has_source(description)) text += "    " + description.source + "\n";
  return text + parameters_help(description.parameters);
}

std::string entry_text(const Description& description, const std::string& kind, const std::string& key) {
  return head(description, kind, key) + parameters_text(description, key.substr(0, key.find('.')));
}

std::string boundary_text(const Description& description) {
  std::string text = description.name + ", boundary condition: " + description.summary + "\n";
  if (has_source(description)) text += "source: " + description.source + "\n";
  text += "in a program: make(catalogue.in_2d.boundaries, \"" + description.name + "\", {...}, name, nodes)\n";
  if (description.parameters.empty()) return text + "parameters: none\n";
  return text + "parameters: name, default, what is allowed, what it is\n" + parameters_help(description.parameters);
}

std::string scheme_text(const Description& description, const Catalogue& catalogue) {
  const bool in_space = catalogue.in_3d.schemes.known(description.name);
  return head(description, "interpolation scheme", "scheme") +
         (in_space ? "in two and three dimensions\n" : "in two dimensions\n") +
         parameters_text(description, "interpolation");
}

std::string law_text(const Materials::Entry& entry) {
  const auto law = entry.make(Values(entry.description.parameters));
  return head(entry.description, "law", "material.model") + parameters_text(entry.description, "material") +
         states_text(*law) + averages_text(*law);
}

} // namespace riedel
