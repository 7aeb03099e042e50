#pragma once

#include <antinode_render/RenderedFocus.h>
#include <antinode_views/Report.h>

namespace antinode
{
/** The report of one rendered focus: scores, warnings, field, spectrum, voltages, probe, transients, spectrogram, tables. [worker] */
ReportPage focusReport (const RenderedFocus&);
} // namespace antinode
