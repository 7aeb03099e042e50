#pragma once

#include "Identification.h"

namespace antinode
{
/** Resonances that differ from point to point: a structure that drifts while its points are measured one after the
   other, or whose sensor or its place loads it. */
struct PointDrift
{
    FrequencyResponses responses; ///< As if the resonances of all points were those of their mean.
    std::string said;             ///< Which and by how much, a sentence.
};

/** Looks for modes that are one: poles within some half widths, which share the points among them so that their shapes
   are not alike, while one pole for each point explains the responses as well as all of them for all points do. Two
   modes of a structure are not explained so.
    @return  nothing where no such modes are
    [worker] Docs/Theory.md, section 8.5. */
std::optional<PointDrift> findPointDrift (const FrequencyResponses&, const IdentifiedModes&);
} // namespace antinode
