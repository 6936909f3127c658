#include "materials/element/follow_path.hpp"

#include "core/base/error.hpp"
#include "materials/element/point_driver.hpp"

namespace riedel {

namespace {

std::string numbered(const PathStage& stage, std::size_t number) {
  const std::string plain = "stage " + std::to_string(number);
  return stage.name == plain ? plain : plain + " (" + stage.name + ")";
}

/// Leads a point through the stages of a path.
class Journey {
public:
  Journey(PointDriver& driver, const ElementPath& path, const ElementWatch& watch, ElementRows& rows,
          ElementCurve& curve)
      : driver_(driver), path_(path), watch_(watch), rows_(rows), curve_(curve) {}

  /// @return whether the test goes on
  bool follow(const PathStage& stage) {
    const auto number = static_cast<std::size_t>(&stage - path_.stages.data()) + 1;
    for (std::int64_t round = 1; round <= stage.repeat; ++round) {
      rows_.begin(static_cast<std::int64_t>(number), round);
      const std::string place = numbered(stage, number) + (stage.repeat > 1 ? ", cycle " + std::to_string(round) : "");
      for (const PathLeg& leg : stage.legs) {
        const End end = follow(leg, stage);
        rows_.write();
        if (end == End::interrupted) curve_.interrupted = place;
        if (end == End::limit) curve_.ends.push_back(place + ": ended by " + stage.until->text());
        if (end != End::reached) return end == End::limit;
      }
    }
    return true;
  }

private:
  enum class End { reached, limit, interrupted };

  End follow(const PathLeg& leg, const PathStage& stage) {
    End end = End::reached;
    driver_.follow(leg_from(leg, driver_.point(), path_.water), [&](const MaterialPoint& point) {
      rows_.record(point);
      if (watch_.stop())
        end = End::interrupted;
      else if (stage.until && stage.until->reached(point, path_.water))
        end = End::limit;
      return end == End::reached;
    });
    return end;
  }

  PointDriver& driver_;
  const ElementPath& path_;
  const ElementWatch& watch_;
  ElementRows& rows_;
  ElementCurve& curve_;
};

} // namespace

ElementCurve follow_path(const Material& law, const MaterialPoint& start, const ElementPath& path,
                         const PathControl& control, const ElementWatch& watch) {
  ElementCurve curve{.test = {}, .water = path.water.present()};
  PointDriver driver(law, start,
                     {.tolerance = control.tolerance,
                      .largest_strain = control.every_strain,
                      .added_stiffness = path.water.bulk_modulus});
  ElementRows rows(law, control.void_ratio, control.every_strain, path.friction, path.water, watch, curve.rows);
  rows.record(start);
  Journey journey(driver, path, watch, rows, curve);
  for (const PathStage& stage : path.stages) {
    if (&stage != &path.stages.front()) driver.begin_stage();
    try {
      if (!journey.follow(stage)) break;
    } catch (const RunError& error) {
      rows.write();
      curve.failure = stage.name + ": " + error.what();
      break;
    }
  }
  curve.steps = driver.steps();
  curve.report = driver.report();
  return curve;
}

} // namespace riedel
