#include "apps/reference.hpp"

#include "apps/biaxial/keys.hpp"
#include "apps/element/keys.hpp"
#include "apps/element/path_keys.hpp"
#include "core/case/case_text.hpp"
#include "core/case/key_tables.hpp"

#include <algorithm>

namespace riedel {

namespace {

std::string law_section(const Description& law) {
  const std::string source = has_source(law) ? " " + law.source + "." : "";
  return "### `model = \"" + law.name + "\"`\n\n" + law.summary + "." + source + "\n\n" +
         (law.parameters.empty() ? "" : keys_markdown(law.parameters));
}

/// The keys of these sections, with their whole names.
std::string dotted_table(const Keys& keys, std::initializer_list<std::string_view> sections) {
  return keys_markdown(keys, std::span(sections.begin(), sections.size()));
}

std::string element_reference(const Catalogue& catalogue) {
  std::string text =
      "# Keys of an element test\n\nA case of `riedel element` names its test, `test = \"triaxial\"`, or "
      "leaves it to the command. `[material]` is that of a biaxial case,\nwith a smaller default of "
      "`tolerance`: " +
      toml_text(element_law_tolerance) + ".\n\n";
  for (const std::string& test : element_tests())
    text += "## `riedel element " + test + "`\n\n" +
            dotted_table(element_keys(catalogue, test, paper_model), {"specimen.", "initial.", "loading."});
  return text + "### `[[stage]]`\n\n" + keys_markdown(stage_keys("")) +
         "One period of a sine can be added to a number or \"hold\": `MEASURE_swing`, the amplitude in the measure's "
         "unit, and "
         "`MEASURE_phase`, the\nangle at the start of the leg [deg], such as `tau_swing = \"20 kPa\"`. A leg accepts "
         "these keys as well.\n\n" +
         "### `[[stage.leg]]`\n\n" + keys_markdown(leg_keys("")) + "## Any of them\n\n" +
         dotted_table(element_keys(catalogue, element_tests().front(), paper_model), {"driver.", "output."});
}

} // namespace

std::string input_reference(const Catalogue& catalogue) {
  std::string text =
      "# Keys of a biaxial case\n\nMade by `riedel check --reference` from the table that also checks the case. "
      "Every key has a default, the paper's value.\nNumbers are SI (angles in degrees) or texts with a unit: "
      "`\"50 kPa\"`, `\"1.5 mm\"`, `\"33 deg\"`.\nOn the command line a key is written with its section: "
      "`--set specimen.width=\"50 mm\"`, `--set grid.cells=[32,112]`.\n\n";
  const Keys keys = biaxial_keys(catalogue, paper_model);
  const auto& laws = catalogue.materials.entries();
  for (auto first = keys.begin(); first != keys.end();) {
    const std::string section = section_of(*first);
    const auto last = std::find_if(first, keys.end(), [&](const Key& key) { return section_of(key) != section; });
    text += section.empty() ? "## Without a section\n\n" : "## `[" + section.substr(0, section.size() - 1) + "]`\n\n";
    const bool is_material = section == "material."; // its first keys are model and plugin, the rest the law's
    text += keys_markdown(Keys(first, is_material ? first + 2 : last));
    if (is_material)
      for (const auto& law : laws) text += law_section(law.description);
    first = last;
  }
  text += element_reference(catalogue);
  text.pop_back(); // one line end is enough for the last line
  return text;
}

} // namespace riedel
