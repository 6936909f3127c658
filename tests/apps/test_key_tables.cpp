#include "apps/biaxial/keys.hpp"
#include "apps/fake_catalogue.hpp"
#include "apps/kinds.hpp"
#include "apps/reference.hpp"
#include "core/case/key_tables.hpp"
#include "support/patterns.hpp"

#include <algorithm>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

using namespace riedel;
using testing::HasSubstr;

TEST(KeyTables, TheHelpMentionsEveryKeyWithDefaultUnitAndRange) {
  const Keys keys = biaxial_keys(fake_catalogue(), paper_model);
  const std::string text = keys_help(keys, ""), words = test::replaced(text, R"(\s+)", " ");
  for (const Key& key : keys) {
    EXPECT_THAT(text, HasSubstr("  " + key.name + " "));
    EXPECT_THAT(words, HasSubstr(key.doc));
    for (const std::string& choice : key.choices) EXPECT_THAT(text, HasSubstr(choice));
  }
  EXPECT_THAT(text, HasSubstr("50000.0 Pa"));
  EXPECT_THAT(words, HasSubstr("30.0 deg (0, 90) critical angle"));
  EXPECT_THAT(words, HasSubstr("\"auto\" auto | > 0 time step"));
}

TEST(KeyTables, TheHelpStaysWithin120Letters) {
  std::istringstream text(keys_help(biaxial_keys(fake_catalogue(), paper_model), "of a test"));
  for (std::string line; std::getline(text, line);)
    EXPECT_LE(std::ranges::count_if(line, [](char c) { return (c & 0xC0) != 0x80; }), 120) << line;
}

TEST(KeyTables, TheReferenceHasARowForEveryKeyAndEveryLaw) {
  const Catalogue catalogue = fake_catalogue();
  const std::string text = input_reference(catalogue);
  for (const Key& key : biaxial_keys(catalogue, "")) { // no such law: the parameters of all
    const std::size_t dot = key.name.find('.');
    const std::string section =
        dot == std::string::npos ? "## Without a section" : "## `[" + key.name.substr(0, dot) + "]`";
    EXPECT_THAT(text, HasSubstr("| `" + key.name.substr(dot + 1) + "` |"));
    EXPECT_THAT(text, HasSubstr(section));
  }
  EXPECT_THAT(text, HasSubstr("### `model = \"linear_elastic\"`"));
  EXPECT_THAT(text, HasSubstr("moving_grid \\| rigid_points")); // a bare | would end the cell
}

TEST(KeyTables, TheSchemaDescribesEveryKey) {
  const Catalogue catalogue = fake_catalogue();
  const auto schema = test::parsed(run_kind("biaxial").cases.schema(CaseFile::empty(), catalogue));
  for (const Key& key : biaxial_keys(catalogue, paper_model)) {
    if (key.name.starts_with("material.")) continue;
    const std::size_t dot = key.name.find('.');
    const auto& properties = schema["properties"];
    const auto& found = dot == std::string::npos
                            ? properties.at(key.name)
                            : properties.at(key.name.substr(0, dot)).at("properties").at(key.name.substr(dot + 1));
    EXPECT_TRUE(found.contains("default")) << key.name;
  }
  EXPECT_EQ(schema["properties"]["specimen"]["additionalProperties"], false);
  EXPECT_EQ(schema["properties"]["grid"]["properties"]["cells"]["items"]["minimum"], 1);
}

TEST(KeyTables, TheSchemaKnowsTheParametersOfEachLaw) {
  const auto schema = test::parsed(run_kind("biaxial").cases.schema(CaseFile::empty(), fake_catalogue()));
  const auto& laws = schema["properties"]["material"]["oneOf"];
  ASSERT_EQ(laws.size(), 2);
  EXPECT_TRUE(laws[0]["properties"].contains("phi_c"));
  EXPECT_FALSE(laws[0].contains("required")); // the default law need not be named
  EXPECT_FALSE(laws[1]["properties"].contains("phi_c"));
  EXPECT_EQ(laws[1]["required"][0], "model");
}

TEST(KeyTables, TheSchemaTakesTextsWithUnits) {
  const auto schema = test::parsed(run_kind("biaxial").cases.schema(CaseFile::empty(), fake_catalogue()));
  const auto& width = schema["properties"]["specimen"]["properties"]["width"]["anyOf"];
  const auto quantity = width.at(1).at("pattern").get<std::string>();
  for (const char* text : {"1.5 mm", "2650 kg/m3", "-1e-3m", "6 %"})
    EXPECT_TRUE(test::matches_whole(text, quantity)) << text;
  for (const char* text : {"wide", "0.04", "", "mm"}) EXPECT_FALSE(test::matches_whole(text, quantity)) << text;
}
