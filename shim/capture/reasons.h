// Why a quad was left as the program gave it. Each is counted under its name in the statistics; docs/semantics.md
// has a line on each.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "truequad/kernel.h"

namespace truequad {

#define TQ_REASONS(REASON)                                                                                \
  REASON(kAffine, affine)                                                                                 \
  REASON(kWithinTolerance, within_tolerance)                                                              \
  REASON(kNotFinite, not_finite)                                                                          \
  REASON(kDegenerate, degenerate)                                                                         \
  REASON(kInvisible, invisible)                                                                           \
  REASON(kNoTextureVaries, no_texture_varies)                                                             \
  REASON(kTexturingOff, texturing_off)                                                                    \
  REASON(kTextureGeneration, texture_generation)                                                          \
  REASON(kProgram, program)                                                                               \
  REASON(kGenericAttribute, generic_attribute)                                                            \
  REASON(kArrayRange, array_range)                                                                        \
  REASON(kBuffer, buffer)                                                                                 \
  REASON(kOwnQ, own_q)                                                                                    \
  REASON(kSelectionOrFeedback, selection_or_feedback)                                                     \
  REASON(kPolygonMode, polygon_mode)                                                                      \
  REASON(kPolygonSmooth, polygon_smooth)                                                                  \
  REASON(kTransformFeedbackOrQuery, transform_feedback_or_query)                                          \
  REASON(kLighting, lighting)                                                                             \
  REASON(kEarlierPass, earlier_pass)                                                                      \
  REASON(kUnmodelledCall, unmodelled_call)                                                                \
  REASON(kMissingExtension, missing_extension)                                                            \
  REASON(kIncomplete, incomplete)                                                                         \
  REASON(kDisplayList, display_list)                                                                      \
  REASON(kUnknownContext, unknown_context)                                                                \
  REASON(kNoMemory, no_memory)                                                                            \
  REASON(kModeOff, mode_off)                                                                              \
  REASON(kPrimitiveOff, primitive_off)

enum class Reason : std::uint8_t {
#define TQ_REASON(constant, name) constant,
  TQ_REASONS(TQ_REASON)
#undef TQ_REASON
      kNone
};
inline constexpr std::size_t kReasonCount = std::size_t(Reason::kNone);

inline constexpr std::string_view kReasonNames[kReasonCount] = {
#define TQ_REASON(constant, name) #name,
    TQ_REASONS(TQ_REASON)
#undef TQ_REASON
};

constexpr Reason reason_of(PassReason reason) {
  switch (reason) {
    case PassReason::kNone: return Reason::kNone;
    case PassReason::kAffine: return Reason::kAffine;
    case PassReason::kConstant: return Reason::kNoTextureVaries;
    case PassReason::kDegenerate: return Reason::kDegenerate;
    case PassReason::kNotFinite: return Reason::kNotFinite;
    case PassReason::kWithinTolerance: return Reason::kWithinTolerance;
    case PassReason::kInvisible: return Reason::kInvisible;
    case PassReason::kModeOff: return Reason::kModeOff;
    case PassReason::kOwnQ: return Reason::kOwnQ;
  }
  return Reason::kNone;
}

}  // namespace truequad
