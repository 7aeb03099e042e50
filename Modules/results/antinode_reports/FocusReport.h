#pragma once

#include "Report.h"

#include <antinode_render/FocusOutcome.h>
#include <antinode_render/PowerFlow.h>

#include <vector>

namespace antinode
{
/** The report of one rendered focus: scores, warnings, field, spectrum, voltages, probe, transients, spectrogram,
    tables. [worker] */
ReportPage focusReport (const RenderedFocus&, const FocusOutcome&);

/** The scores of a focus, each with a sentence that explains it, for the report and the editor: first what was wanted
   and what is reached, then what limits it, then the internal scores. [any] */
std::vector<ReportScore> focusScores (const RenderedFocus&, const FocusOutcome&);

/** Current, energy and power of an event, a focus or waveforms at fingers, and of its repetition: per ceramic, in all,
   and of amplifiers. [worker] Docs/Theory.md, section 6.8. */
ReportSection powerSection (const ModalModel&, const FocusPower&);
} // namespace antinode
