#include "apps/biaxial_keys.hpp"
#include "apps/key_tables.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace riedel {

namespace {

using Json = nlohmann::ordered_json;

Json with_bounds(Json schema, const Bounds& bounds) {
  if (std::isfinite(bounds.lower)) schema[bounds.lower_included ? "minimum" : "exclusiveMinimum"] = bounds.lower;
  if (std::isfinite(bounds.upper)) schema[bounds.upper_included ? "maximum" : "exclusiveMaximum"] = bounds.upper;
  return schema;
}

/// A number, or a text that begins like one: the unit is checked by the program.
Json number(const Key& key) {
  Json any = Json::array({with_bounds({{"type", "number"}}, key.bounds)});
  if (!key.unit.empty())
    any.push_back({{"type", "string"}, {"pattern", R"(^\s*[-+]?[0-9.]+([eE][-+]?[0-9]+)?\s*[^0-9.\s].*$)"}});
  if (!key.choices.empty()) any.push_back({{"enum", key.choices}});
  return {{"anyOf", any}};
}

struct TypeOf {
  const Key& key;
  Json operator()(bool) const { return {{"type", "boolean"}}; }
  Json operator()(std::int64_t) const { return with_bounds({{"type", "integer"}}, key.bounds); }
  Json operator()(double) const { return number(key); }
  Json operator()(const std::string&) const {
    if (key.takes_number()) return number(key);
    return key.choices.empty() ? Json{{"type", "string"}} : Json{{"enum", key.choices}};
  }
  template <class Number>
  Json operator()(const std::vector<Number>& list) const {
    return {{"type", "array"}, {"items", (*this)(Number{})}, {"minItems", list.size()}, {"maxItems", list.size()}};
  }
};

Json property(const Key& key) {
  Json schema = std::visit(TypeOf{key}, key.default_value);
  schema["description"] = key.doc + (key.unit.empty() || key.unit == "-" ? "" : " [" + key.unit + "]");
  std::visit([&](const auto& value) { schema["default"] = value; }, key.default_value);
  return schema;
}

Json section_schema() { return {{"type", "object"}, {"additionalProperties", false}, {"properties", Json::object()}}; }

/// [material] with one law: its name, which only the default law may leave out, and its parameters.
Json material_schema(const Description& law) {
  Json schema = section_schema();
  schema["title"] = law.name;
  schema["properties"]["model"] = {{"const", law.name}, {"description", law.summary}};
  if (law.name != paper_model) schema["required"] = {"model"};
  for (const Key& key : law.parameters) schema["properties"][key.name] = property(key);
  return schema;
}

} // namespace

std::string biaxial_schema(const Catalogue& catalogue) {
  Json schema = section_schema();
  Json& properties = schema["properties"];
  for (const Key& key : biaxial_keys(catalogue, paper_model)) {
    const std::size_t dot = key.name.find('.');
    const std::string section = key.name.substr(0, dot);
    if (section == "material") continue;
    if (dot == std::string::npos) {
      properties[key.name] = property(key);
      continue;
    }
    if (!properties.contains(section)) properties[section] = section_schema();
    properties[section]["properties"][key.name.substr(dot + 1)] = property(key);
  }
  Json laws = Json::array();
  for (const auto& law : catalogue.materials.entries()) laws.push_back(material_schema(law.description));
  properties["material"] = {{"oneOf", laws}};
  Json document = {{"$schema", "http://json-schema.org/draft-07/schema#"}, {"title", "A biaxial case of Riedel"}};
  document.update(schema);
  return document.dump(2) + "\n";
}

} // namespace riedel
