// plan(): what to draw for one quad, from its shape, its view and the mode; docs/design.md "Choosing a mesh".
#include <algorithm>
#include <cmath>
#include <limits>

#include "planners.h"
#include "verify.h"

namespace truequad {
namespace {

using kernel::Budget;
using kernel::ErrorModel;

// Mode::kAuto takes the projective map up to this ratio of its factors: beyond it the texture is compressed
// more strongly along the quad than the eye takes for perspective.
constexpr double kAutoSpread = 4;

void pass(Plan& out, PassReason reason) {
  out.action = Action::kPass;
  out.reason = reason;
  out.triangles = 2;
}

PassReason reason_of(Shape shape) { return shape == Shape::kAffine ? PassReason::kAffine : PassReason::kConstant; }

// False if no channel is warped.
bool add_colours(const Corners& position, std::span<const ColourChannel> colours, const Budget& budget, ErrorModel& model) {
  model.colours.count = 0;
  if (colours.empty() || !kernel::add_colours(position, colours, model.screen, model.colours)) return false;
  model.colours.px_per_step = budget.mesh_px / budget.colour_steps;
  model.colours.snap_px = budget.snap_px - budget.rounding_px;
  model.colours.rounding_px = budget.rounding_px;
  return true;
}

// Texels and colours were bound together, if at all; says what each is promised.
void tell_apart(const ErrorModel& model, const Budget& budget, Plan& plan) {
  double texture_px = plan.bound_px - budget.snap_px, colour_px = texture_px;
  if (plan.action == Action::kMesh && (texture_px > budget.mesh_px || model.colours.folded)) {
    ErrorModel one = model;
    one.map_count = 0;
    colour_px = kernel::block_bound(one, plan, budget.mesh_px);
    one.map_count = model.map_count;
    one.colours.count = 0;
    texture_px = kernel::block_bound(one, plan, budget.mesh_px);
  }
  plan.bound_px = model.map_count > 0 ? texture_px + budget.snap_px : 0;
  plan.bound_steps = colour_px / model.colours.px_per_step;
  plan.capped = !(plan.bound_px <= budget.tolerance_px) || !(plan.bound_steps <= budget.colour_steps);
}

bool finite(const View& view) {
  const Viewport& v = view.viewport;
  double sum = std::fabs(v.x) + std::fabs(v.y) + std::fabs(v.width) + std::fabs(v.height);
  for (double element : view.clip_from_object) sum += std::fabs(element);
  return std::isfinite(sum);
}

}  // namespace

Budget kernel::make_budget(const Limits& limits, const View& view, double rounding_px) {
  const Limits defaults;
  const auto positive = [](double value, double otherwise, double low, double high) {
    return value > 0 ? std::clamp(value, low, high) : otherwise;
  };
  Budget budget;
  budget.tolerance_px = positive(limits.tolerance_px, defaults.tolerance_px, 1e-3, 1e6);
  budget.rounding_px = rounding_px;
  budget.snap_px = positive(view.snap_px, 0, 0, 1) + rounding_px;
  // A tolerance of the order of the rasteriser's own grid leaves half of it to the mesh; the bound says the
  // rest.
  budget.native_px = std::max(budget.tolerance_px - budget.snap_px, budget.tolerance_px / 2);
  // Cells of a mesh that is much finer than rounding would fold, and cover pixels more than once.
  budget.mesh_px = std::max(budget.native_px, rounding_px / 2);
  budget.colour_steps = positive(limits.colour_steps, defaults.colour_steps, 1e-3, 255);
  budget.max_triangles = std::clamp(limits.max_triangles, 4, kMaxTriangles);
  budget.paper.object = positive(limits.paper.object, defaults.paper.object, 0, 2);
  budget.paper.texture = positive(limits.paper.texture, defaults.paper.texture, 0, 2);
  budget.paper.area_px = positive(limits.paper.area_px, defaults.paper.area_px, 1, 1e12);
  return budget;
}

namespace {

void plan_at_centres(const Corners& position, std::span<const Corners> textures, const View& view, const Limits& limits,
                     Mode mode, Plan& out, std::span<const ColourChannel> colours) {
  out.action = Action::kPass;
  out.reason = PassReason::kNone;
  out.bound_px = out.bound_steps = 0;
  out.capped = false;
  out.triangles = 2;
  out.u.count = out.v.count = 0;
  out.collapsed_edge = {};
  out.leaf_count = 0;

  textures = textures.first(std::min(textures.size(), kMaxTextureSets));
  if (mode == Mode::kOff) return pass(out, PassReason::kModeOff);
  if (mode == Mode::kPaper) colours = {};
  const Shape shape = classify(position, textures);
  switch (shape) {
    case Shape::kAffine:
    case Shape::kConstant:
      // Exact in any mesh.
      textures = {};
      if (!colours.empty()) break;
      return pass(out, reason_of(shape));
    case Shape::kDegenerate:
      return pass(out, PassReason::kDegenerate);
    case Shape::kNotFinite:
      return pass(out, PassReason::kNotFinite);
    case Shape::kWarped:
      break;
  }
  if (!finite(view)) return pass(out, PassReason::kNotFinite);
  if (!(view.viewport.width > 0) || !(view.viewport.height > 0)) return pass(out, PassReason::kInvisible);

  ErrorModel model;
  if (!kernel::make_screen_quad(position, view, model.screen)) return pass(out, PassReason::kNotFinite);
  model.rasteriser = kernel::make_rasteriser(view);
  const Budget budget =
      kernel::make_budget(limits, view, vertex_rounding_px(model.rasteriser, position, view, model.screen));
  if (!add_colours(position, colours, budget, model) && shape != Shape::kWarped) return pass(out, reason_of(shape));
  if (model.screen.invisible()) return pass(out, PassReason::kInvisible);

  if (!textures.empty() && (mode == Mode::kProjective || mode == Mode::kAuto)) {
    double spread;
    if (kernel::plan_projective(position, textures, model, budget, out, spread) &&
        (mode == Mode::kProjective || spread <= kAutoSpread)) {
      return;
    }
    out.action = Action::kPass;
  }
  if (!kernel::add_texture_maps(position, textures, model)) return pass(out, PassReason::kOwnQ);
  if (mode == Mode::kPaper) return kernel::plan_paper(position, textures, model, budget, out);
  // Where colours have no promise they may not cost the texture its own.
  const std::size_t channels = model.colours.count;
  if (channels > 0 && model.colours.folded && model.map_count > 0) model.colours.count = 0;
  kernel::plan_bilinear(model, budget, out);
  if (channels == 0) return;
  if (model.colours.count == 0) {
    model.colours.count = channels;
    if (out.action == Action::kPass) kernel::plan_bilinear(model, budget, out);
  }
  tell_apart(model, budget, out);
}

}  // namespace

void plan(const Corners& position, std::span<const Corners> textures, const View& view, const Limits& limits,
          Mode mode, Plan& out, std::span<const ColourChannel> colours) {
  plan_at_centres(position, textures, view, limits, mode, out, colours);
  out.capped |= view.multisampled && out.action != Action::kPass;
}

void bound_mesh(const Corners& position, std::span<const Corners> textures, const View& view, const Limits& limits,
                Plan& mesh, std::span<const ColourChannel> colours) {
  textures = textures.first(std::min(textures.size(), kMaxTextureSets));
  ErrorModel model;
  model.rasteriser = kernel::make_rasteriser(view);
  const bool seen = kernel::make_screen_quad(position, view, model.screen);
  const Budget budget = kernel::make_budget(
      limits, view, seen ? vertex_rounding_px(model.rasteriser, position, view, model.screen) : 0);
  mesh.bound_px = mesh.bound_steps = 0;
  if (classify(position, textures) == Shape::kWarped) {
    mesh.bound_px = !seen || !kernel::add_texture_maps(position, textures, model)
                        ? std::numeric_limits<double>::infinity()
                    : mesh.leaf_count > 0 ? kernel::leaves_bound(model, mesh)
                                          : kernel::block_bound(model, mesh, budget.mesh_px);
  }
  mesh.bound_px += budget.snap_px;
  if (!colours.empty() && mesh.leaf_count == 0 && seen) {
    model.map_count = 0;
    if (add_colours(position, colours, budget, model)) {
      mesh.bound_steps = kernel::block_bound(model, mesh, budget.mesh_px) / model.colours.px_per_step;
    }
  }
  mesh.capped = view.multisampled || !(mesh.bound_px <= budget.tolerance_px) || !(mesh.bound_steps <= budget.colour_steps);
}

}  // namespace truequad
