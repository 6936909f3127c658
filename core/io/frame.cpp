#include "core/io/frame.hpp"

#include "core/base/error.hpp"

#include <algorithm>
#include <cmath>

namespace riedel {

bool Frame::has(const std::string& name) const { return std::ranges::find(fields, name, &Field::name) != fields.end(); }

const Field& Frame::field(const std::string& name) const {
  std::string known;
  for (const Field& f : fields) {
    if (f.name == name) return f;
    known += (known.empty() ? "" : ", ") + f.name;
  }
  throw InputError("no field '" + name + "' to draw; there are: " + known);
}

double Frame::scalar(const std::string& name) const {
  if (const auto at = scalars.find(name); at != scalars.end()) return at->second;
  std::string known;
  for (const auto& [each, value] : scalars) known += (known.empty() ? "" : ", ") + each;
  throw InputError("no scalar '" + name + "' in the frame; there are: " + (known.empty() ? "none" : known));
}

void Frame::check() const {
  const auto require = [](bool holds, const std::string& what) {
    if (!holds) throw std::logic_error("frame: " + what);
  };
  require(dimension == 2 || dimension == 3, "dimension is neither 2 nor 3");
  require(position.size() % 3 == 0, "positions need three coordinates");
  require(corners.empty() || corners.size() == position.size() * static_cast<std::size_t>(corners_per_point()),
          "corners do not match the points");
  for (const Field& f : fields)
    require(f.values.size() == points() * static_cast<std::size_t>(f.components),
            "field '" + f.name + "' does not match the points");
}

Frame deformable_points(const Frame& frame) {
  if (!frame.has("mass")) return frame;
  const std::vector<double>& mass = frame.field("mass").values;
  if (std::ranges::none_of(mass, [](double m) { return std::isnan(m); })) return frame;
  const auto chosen = [&](const std::vector<double>& values) {
    const std::size_t of_each = values.size() / mass.size();
    std::vector<double> left;
    for (std::size_t p = 0; p < mass.size(); ++p)
      if (!std::isnan(mass[p]))
        left.insert(left.end(), values.begin() + static_cast<std::ptrdiff_t>(p * of_each),
                    values.begin() + static_cast<std::ptrdiff_t>((p + 1) * of_each));
    return left;
  };
  Frame result = frame;
  result.position = chosen(frame.position);
  result.corners = chosen(frame.corners);
  for (Field& field : result.fields) field.values = chosen(field.values);
  return result;
}

} // namespace riedel
