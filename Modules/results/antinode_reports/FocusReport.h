#pragma once

#include "Report.h"

#include <antinode_render/FocusOutcome.h>

namespace antinode
{
/** The report of one rendered focus: scores, warnings, field, spectrum, voltages, probe, transients, spectrogram,
    tables. [worker] */
ReportPage focusReport (const RenderedFocus&, const FocusOutcome&);
} // namespace antinode
