#pragma once

#include "Report.h"

#include <antinode_render/PerformedWaveforms.h>

namespace antinode
{
/** Wanted and reached waveforms of all fingers side by side, over time, mm and um. [worker] */
ChartGrid fingerWaveformsChart (const PerformedWaveforms&);

/** The report of waveforms at fingers: scores, what each finger gets over time and frequency, the felt level elsewhere,
    voltages, a table, power. [worker] */
ReportPage waveformsReport (const PerformedWaveforms&);
} // namespace antinode
