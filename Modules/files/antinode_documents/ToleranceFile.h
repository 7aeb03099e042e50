#pragma once

#include <antinode_base/Reflection.h>
#include <antinode_focus/Tolerance.h>

#include <nlohmann/json_fwd.hpp>

#include <vector>

namespace antinode
{
inline constexpr WordList<ToleranceKind, 4> toleranceKindWords { { { "frequency", ToleranceKind::frequency },
                                                                   { "damping", ToleranceKind::damping },
                                                                   { "participation", ToleranceKind::participation },
                                                                   { "drift", ToleranceKind::drift } } };

/** Tolerances as tolerance.json: the same devices for every design. Docs/FileFormats.md.
    @param focus  its name
    @param designs  at least one, all with the same options
    [worker] */
nlohmann::ordered_json toleranceToJson (const ModalModel&, const std::string& focus,
                                        const std::vector<DesignTolerance>& designs);
} // namespace antinode
