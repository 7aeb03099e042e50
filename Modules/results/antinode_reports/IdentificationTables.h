#pragma once

#include "IdentificationReport.h"

namespace antinode
{
/** The origin of the scale of the shapes, as a sentence. [any] */
std::string scalingInWords (const IdentifiedModes&);

/** Modes, points, references and band in one phrase. [any] */
std::string sizeInWords (const IdentificationResult&);

/** The warnings of collectWarnings(), those of modes as one sentence that names the modes. [any] */
std::vector<std::string> summariseWarnings (const IdentificationResult&);

/** A column for modeTable(): the warnings of each mode. [any] */
std::vector<std::string> warningColumn (const IdentificationResult&);

/** The delay with its standard deviation, us: "10.700 +- 0.003" [any] */
std::string delayInWords (const IdentifiedModes&);

/** One row per mode: frequency and damping ratio with standard deviations, quality. [any] */
ReportTable modeTable (const IdentificationResult&);

/** One row per pair of an identified and a computed mode: frequencies, their difference, MAC. There is a comparison.
    [any] */
ReportTable pairTable (const IdentificationResult&);

/** A table as text in columns for a terminal. [any] */
std::string tableText (const ReportTable&);
} // namespace antinode
