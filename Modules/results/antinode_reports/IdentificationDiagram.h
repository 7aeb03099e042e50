#pragma once

#include "IdentificationReport.h"

namespace antinode
{
/** A page to work with an identification in a browser: stabilisation diagram with zoom, candidates to pick and reject,
   the option of `antinode identify` that says so, mode indicator, each response against its synthesis with the error,
   moving shapes. One HTML file with its script, no network. Its state is in the address after #: Docs/Manual,
   identification.
    @param reportName  the file of the static report in the same folder; none if empty
    [worker] */
std::string identificationDiagram (const IdentificationResult&, const std::string& reportName);
} // namespace antinode
