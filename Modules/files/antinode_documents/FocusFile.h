#pragma once

#include <antinode_allocation/Allocation.h>
#include <antinode_base/Reflection.h>
#include <antinode_focus/FocusDescription.h>
#include <antinode_focus/LimitUse.h>

#include <nlohmann/json_fwd.hpp>

#include <algorithm>
#include <string>
#include <utility>

namespace antinode
{
/** A focus from JSON. Docs/FileFormats.md.
    @param source  how errors name it
    @throws InputError  source, JSON pointer, what is wrong, what is allowed, "did you mean"
    [worker] */
FocusDescription readFocus (const nlohmann::json&, const std::string& source);

/** A focus as JSON that readFocus reads: what was left to choice stays out. [worker] */
nlohmann::ordered_json focusToJson (const FocusDescription&);

/** The words of focus files, in both directions. */
inline constexpr WordList<TargetShape, 3> targetShapeWords {
    { { "sinc", TargetShape::sinc }, { "bump", TargetShape::bump }, { "gaussian", TargetShape::gaussian } }
};

inline constexpr WordList<TargetProfile, 2> targetProfileWords { { { "radial", TargetProfile::radial },
                                                                   { "separable", TargetProfile::separable } } };

inline constexpr WordList<ModeOrder, 2> modeOrderWords { { { "energy", ModeOrder::energy },
                                                           { "frequency", ModeOrder::frequency } } };

inline constexpr WordList<FeltAt, 2> feltAtWords { { { "everywhere", FeltAt::everywhere },
                                                     { "fingers", FeltAt::fingers } } };

inline constexpr WordList<DriveKind, 2> driveKindWords { { { "offset_free", DriveKind::offsetFree },
                                                           { "paper", DriveKind::paper } } };

inline constexpr auto fingerKindWords = []
{
    WordList<const char*, fingerKinds.size()> words;
    std::transform (fingerKinds.begin(), fingerKinds.end(), words.begin(),
                    [] (const auto& each) { return std::pair (std::string_view (each.name), each.name); });
    return words;
}();

/** The multiple of the bound that is a word. */
inline constexpr WordList<double, 1> timesBoundWords { { { "limit", upToLimits } } };

inline constexpr WordList<AllocationStatus, 3> allocationStatusWords {
    { { "unconstrained", AllocationStatus::unconstrained },
      { "optimal", AllocationStatus::optimal },
      { "infeasible", AllocationStatus::infeasible } }
};

inline constexpr WordList<LimitKind, 6> limitKindWords { { { "ceramic", LimitKind::ceramic },
                                                           { "focus", LimitKind::focus },
                                                           { "amplifier", LimitKind::amplifier },
                                                           { "full_scale", LimitKind::fullScale },
                                                           { "slew", LimitKind::slew },
                                                           { "current", LimitKind::current } } };
} // namespace antinode
