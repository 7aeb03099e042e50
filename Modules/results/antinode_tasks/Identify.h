#pragma once

#include "Field.h"

#include <antinode_base/Progress.h>
#include <antinode_identification/Identification.h>
#include <antinode_reports/IdentificationReport.h>
#include <antinode_structure/DeviceDescription.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace antinode
{
inline constexpr TaskText identifyText { "identify", "Finds the modes in measured frequency responses",
                                         "Docs/Theory.md, section 8; Docs/FileFormats.md, \"Measured responses\"" };

/** Measured responses, what files do not say of them, and how modes are searched. */
struct IdentifyRequest
{
    std::vector<std::filesystem::path> files;
    std::string name = "identified";
    std::optional<DeviceDescription> against; ///< A computed device to compare with.
    std::filesystem::path outline;            ///< Where the surface ends; empty: as that of the computed device.
    std::vector<FrequencyBand> bands;
    std::optional<std::pair<int, int>> orders; ///< Lowest and highest.
    std::optional<std::string> kind;           ///< "real" or "complex"; none: as a test decides.
    bool isGramSchmidt = false, usesPeaks = false, usesCache = true;
    std::vector<double> selected, rejected; ///< Hz
    std::optional<double> delay;            ///< s
    std::optional<std::string> form;        ///< Of tables without headings.
    std::optional<std::string> quantity, responseUnit, drive, driveUnit;
    std::filesystem::path pointsFile;
    std::vector<std::string> references, variables;
    std::optional<double> mass;             ///< kg
    std::optional<double> windowDecay;      ///< 1/s; none: as the files say.
    double voltageLimit = 150;              ///< V
    std::optional<double> fullScaleVoltage; ///< V; none: that of the computed device, else the voltage limit.
};

/** [any] */
std::vector<Field> fields (IdentifyRequest&);

/** The modes of measured files.
    @param progress  may be empty
    @throws InputError  for files that cannot be read, options that are not allowed, and where there are no modes
    [worker] */
IdentificationResult identify (const IdentifyRequest&, const ShowProgress& progress);

/** In dB; also that of the measured quantity where it is not a velocity, and of the modes alone, which are all that a
    device has, where residual terms make a difference. [any] */
std::string reconstructionError (const IdentificationResult&);

/** The device file. [worker] Docs/FileFormats.md. */
std::string identifiedDeviceText (const IdentificationResult&);

/** Files of an identification; empty names: none. */
struct IdentifiedFiles
{
    std::filesystem::path device, report, universalFile, transferred;
};

/** Writes them, all or none. A report has a diagram to pick modes beside it.
    @throws InputError  when one cannot be written, and to transfer without a computed device [worker] */
void writeIdentified (const IdentificationResult&, const IdentifiedFiles&);
} // namespace antinode
