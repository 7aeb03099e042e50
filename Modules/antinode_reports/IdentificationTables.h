#pragma once

#include "IdentificationReport.h"

namespace antinode
{
/** The origin of the scale of the shapes, as a sentence. [any] */
std::string scalingInWords (const IdentifiedModes&);

/** One row per mode: frequency and damping ratio with standard deviations, quality. [any] */
ReportTable modeTable (const IdentificationResult&);

/** One row per pair of an identified and a computed mode: frequencies, their difference, MAC. There is a comparison.
    [any] */
ReportTable pairTable (const IdentificationResult&);

/** A table as text in columns for a terminal. [any] */
std::string tableText (const ReportTable&);
} // namespace antinode
