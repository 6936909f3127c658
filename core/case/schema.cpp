#include "core/case/schema.hpp"

#include "core/case/plugins.hpp"

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

/// A number, or a text that begins like one: the program checks the unit.
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
    Json schema{{"type", "array"}, {"items", (*this)(Number{})}};
    if (!key.any_length) schema.update({{"minItems", list.size()}, {"maxItems", list.size()}});
    return schema;
  }
};

Json property(const Key& key) {
  Json schema = std::visit(TypeOf{key}, key.default_value);
  schema["description"] = key.doc + (key.unit.empty() || key.unit == "-" ? "" : " [" + key.unit + "]");
  std::visit([&](const auto& value) { schema["default"] = value; }, key.default_value);
  return schema;
}

Json section_schema() { return {{"type", "object"}, {"additionalProperties", false}, {"properties", Json::object()}}; }

/// [material] with one law: its name, optional only for the default law, and its parameters.
Json material_schema(const Description& law, const std::string& usual) {
  Json schema = section_schema();
  schema["title"] = law.name;
  schema["properties"]["model"] = {{"const", law.name}, {"description", law.summary}};
  if (law.name != usual) schema["required"] = {"model"};
  schema["properties"]["plugin"] = property(plugin_key("material", "the law"));
  for (const Key& key : law.parameters) schema["properties"][key.name] = property(key);
  return schema;
}

/// The keys of a section, created if missing.
Json& section_in(Json& properties, const std::string& name) {
  if (!properties.contains(name)) properties[name] = section_schema();
  return properties[name]["properties"];
}

} // namespace

Json object_schema(const Keys& keys) {
  Json schema = section_schema();
  for (const Key& key : keys) schema["properties"][key.name] = property(key);
  return schema;
}

Json case_schema(const std::string& title, const Keys& keys, const Catalogue& catalogue) {
  Json schema = section_schema();
  Json& properties = schema["properties"];
  for (const Key& key : keys) {
    const std::size_t dot = key.name.find('.');
    const std::string section = key.name.substr(0, dot);
    if (section == "material") continue;
    if (dot == std::string::npos)
      properties[key.name] = property(key);
    else
      section_in(properties, section)[key.name.substr(dot + 1)] = property(key);
  }
  const std::string usual = Values(keys).text("material.model");
  Json laws = Json::array();
  for (const auto& law : catalogue.materials.entries()) laws.push_back(material_schema(law.description, usual));
  properties["material"] = {{"oneOf", laws}};
  Json document = {{"$schema", "http://json-schema.org/draft-07/schema#"}, {"title", title}};
  document.update(schema);
  return document;
}

} // namespace riedel
