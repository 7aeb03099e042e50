#include "Measuring.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/Progress.h>
#include <antinode_base/Watch.h>
#include <antinode_base/WholeFile.h>
#include <antinode_responses/PointResponseFile.h>
#include <antinode_text/CsvText.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

namespace antinode
{
namespace
{
constexpr const char* pointsFile = "points.csv";
constexpr const char* sheetFile = "excitation.json";
constexpr const char* signalFile = "signal.wav";

std::string pointsText (const Eigen::MatrixX2d& points)
{
    constexpr int digits = 12;
    std::string text = "x_mm,y_mm\n";

    for (Eigen::Index p = 0; p < points.rows(); ++p)
    {
        appendCsvNumber (text, points (p, 0) * 1000, digits);
        text += ',';
        appendCsvNumber (text, points (p, 1) * 1000, digits);
        text += '\n';
    }

    return text;
}
} // namespace

MeasurementFolder::MeasurementFolder (std::filesystem::path folderToUse, const ExcitationSheet& sheet,
                                      const Eigen::MatrixX2d& points)
    : folder (std::move (folderToUse))
{
    const auto sheetText = excitationToJson (sheet, signalFile).dump (2) + "\n", places = pointsText (points);

    if (std::error_code unknown; std::filesystem::exists (folder / sheetFile, unknown))
    {
        if (readWholeFile (folder / sheetFile, {}) != sheetText || readWholeFile (folder / pointsFile, {}) != places)
            throw InputError (folder.string(),
                              "contains a measurement with another excitation or other points; choose another folder");

        return;
    }

    OutputFolder output (folder);
    output.write (pointsFile, places);
    writeSheet (output, sheet);
    output.commit();
}

std::filesystem::path MeasurementFolder::pointFile (Eigen::Index point) const
{
    std::array<char, 32> name {};
    std::snprintf (name.data(), name.size(), "point-%04td.uff", point + 1);
    return folder / name.data();
}

bool MeasurementFolder::has (Eigen::Index point) const
{
    return std::filesystem::exists (pointFile (point));
}

void MeasurementFolder::keep (const SurfaceMeasurement& measurement, Eigen::Index point) const
{
    writeWholeFile (pointFile (point), encodePoint (measurement, point));
}

void MeasurementFolder::restore (SurfaceMeasurement& measurement, Eigen::Index point) const
{
    const auto file = pointFile (point);
    restorePoint (measurement, point, readWholeFile (file, {}), file.string());
}

namespace
{
constexpr double clipping = 0.999; // of full scale

void tell (const PointGuide& guide, const std::string& sentence)
{
    if (guide.tell)
        guide.tell (sentence);
}

/** All that stays the same from point to point. */
struct Measuring
{
    Bench& bench;
    const ExcitationSheet& sheet;
    const Eigen::MatrixX2d& points;
    const PointGuide& guide;
    const RunAnalysisSettings& settings;
    const ModalModel& drawn;
    TimeLeft left {}; ///< From the first point that is measured.
};

Eigen::Index pointsKept (const MeasurementFolder& folder, Eigen::Index points)
{
    Eigen::Index kept = 0;

    for (Eigen::Index p = 0; p < points; ++p)
        kept += folder.has (p) ? 1 : 0;

    return kept;
}

std::string keptInWords (const MeasurementFolder& folder, Eigen::Index points)
{
    return formatted ("ended with %td of %td points kept; the same command resumes it", pointsKept (folder, points),
                      points);
}

/** One run. @throws Cancelled  if the user interrupts it */
RunRecording playRun (const Measuring& measuring, const Excitation& excitation, Eigen::Index ceramic,
                      Eigen::Index first, Eigen::Index count)
{
    checkWatch();

    if (measuring.guide.plays)
        measuring.guide.plays (ceramic);

    return measuring.bench.play (excitation, ceramic, first, count);
}

/** Plays every ceramic at a low level and predicts the inputs at full level. */
void checkLevels (const Measuring& measuring, Eigen::Index first, Eigen::Index count)
{
    const auto quiet = levelCheckExcitation (measuring.sheet);
    const auto fullScale = measuring.bench.fullScaleVelocity();
    double largest = 0, latency = measuring.settings.latency;

    for (Eigen::Index ceramic = 0; ceramic < quiet.ceramics(); ++ceramic)
    {
        const auto run = playRun (measuring, quiet, ceramic, first, count);
        latency = analyseRun (quiet, ceramic, run, measuring.settings).latency;
        largest =
            std::max (largest, run.sensors.cwiseAbs().maxCoeff() * measuring.sheet.excitation.settings.levels[ceramic]
                                   / quiet.settings.levels[ceramic]);
    }

    if (! (largest > 0))
        throw InputError ("sensor", "has no signal at its input: is it wired to that input?");

    if (std::isfinite (fullScale) && largest > clipping * fullScale)
        throw InputError ("sensor",
                          formatted ("would drive its input to %.0f %% of full scale; choose a lower --level-v, "
                                     "or a larger range of the sensor or the input",
                                     100 * largest / fullScale));

    tell (measuring.guide,
          formatted ("level check: at most %.3g mm/s at full level%s, latency %.2f samples", largest * 1000,
                     std::isfinite (fullScale)
                         ? formatted (", %.1f %% of the input's full scale", 100 * largest / fullScale).c_str()
                         : "",
                     latency));
}

/** "point 3 of 99" or "points 17 to 32 of 99". */
std::string pointsInWords (Eigen::Index first, Eigen::Index count, Eigen::Index points)
{
    return count == 1 ? formatted ("point %td of %td", first + 1, points)
                      : formatted ("points %td to %td of %td", first + 1, first + count, points);
}

/** Runs all ceramics one after the other. @return whether no input clipped */
bool measureAt (const Measuring& measuring, SurfaceMeasurement& measurement, Eigen::Index first, Eigen::Index count)
{
    const auto points = measuring.points.rows();
    double largest = 0;

    for (Eigen::Index ceramic = 0; ceramic < measuring.sheet.excitation.ceramics(); ++ceramic)
    {
        const auto run = playRun (measuring, measuring.sheet.excitation, ceramic, first, count);
        largest = std::max (largest, run.sensors.cwiseAbs().maxCoeff());
        place (measurement, ceramic, first, analyseRun (measuring.sheet.excitation, ceramic, run, measuring.settings));
    }

    const auto share = largest / measuring.bench.fullScaleVelocity();
    const auto coherence = meanCoherence (measurement).middleRows (first, count).mean();
    const auto pace = measuring.left.at (static_cast<double> (first + count) / static_cast<double> (points));
    tell (measuring.guide,
          formatted ("%s: at most %.3g mm/s, coherence %.5f%s%s", pointsInWords (first, count, points).c_str(),
                     largest * 1000, coherence, share > clipping ? ", CLIPPED: not kept" : "",
                     pace.empty() ? "" : ("; " + pace).c_str()));
    return ! (share > clipping);
}

[[noreturn]] void endForNow (const MeasurementFolder& folder, Eigen::Index points)
{
    throw InputError ("measurement", keptInWords (folder, points));
}

/** The number of points from one on that are measured together. */
Eigen::Index pointsTogether (const Bench& bench, const MeasurementFolder& folder, Eigen::Index first,
                             Eigen::Index points)
{
    auto end = first + 1;

    while (end < points && end - first < bench.sensors() && ! folder.has (end))
        ++end;

    return end - first;
}

/** While a wrong wire is still easily changed, and once more when all is known. */
void tellWiring (const Measuring& measuring, const SurfaceMeasurement& measurement)
{
    const auto findings = checkWiring (measuring.drawn, measurement.responses);

    if (measuring.guide.wires)
        return measuring.guide.wires (measurement, findings);

    for (const auto& found : findings)
        tell (measuring.guide, "wiring: " + wireInWords (found));
}

SurfaceMeasurement measureAll (const Measuring& measuring, const MeasurementFolder& folder)
{
    const auto& [bench, sheet, points, guide, settings, drawn, left] = measuring;
    auto measurement = unmeasured (sheet.excitation, sheet.ceramics, points);
    Eigen::Index before = -1;
    bool isChecked = false;

    for (Eigen::Index first = 0, repeated = -1; first < points.rows();)
    {
        if (folder.has (first) && first != repeated)
        {
            folder.restore (measurement, first++);
            continue;
        }

        const auto count = pointsTogether (bench, folder, first, points.rows());
        const auto answer = guide.ask ? guide.ask (points, first, count) : PointAnswer::measure;
        checkWatch();

        if (answer == PointAnswer::end)
            endForNow (folder, points.rows());

        if (answer == PointAnswer::again && before >= 0)
            repeated = first = before;
        else if (answer == PointAnswer::skip)
            first += count;
        else if (answer == PointAnswer::measure)
        {
            if (! std::exchange (isChecked, true))
                checkLevels (measuring, first, count);

            if (measureAt (measuring, measurement, first, count))
            {
                if (before < 0 && count < points.rows())
                    tellWiring (measuring, measurement);

                for (auto p = first; p < first + count; ++p)
                    folder.keep (measurement, p);

                before = first;
                repeated = -1;
                first += count;
            }
            else if (! guide.ask)
                endForNow (folder, points.rows());
        }
    }

    tellWiring (measuring, measurement);
    return measurement;
}
} // namespace

Excitation levelCheckExcitation (const ExcitationSheet& sheet)
{
    constexpr double coarse = 20, share = 0.1;
    auto settings = sheet.excitation.settings;
    settings.signal = ExcitationSignal::multisine;
    settings.hasOddGrid = false;
    settings.resolution =
        std::min (std::max (coarse, settings.resolution), (settings.highestFrequency - settings.lowestFrequency) / 4);
    settings.periods = settings.settlingPeriods = 1;
    settings.levels *= share;
    return makeExcitation (settings, sheet.voltageLimits);
}

SurfaceMeasurement measurePoints (Bench& bench, const ExcitationSheet& sheet, const Eigen::MatrixX2d& points,
                                  const MeasurementFolder& folder, const PointGuide& guide,
                                  const RunAnalysisSettings& settings, const ModalModel& drawn)
{
    const auto kept = static_cast<double> (pointsKept (folder, points.rows()));

    try
    {
        return measureAll ({ bench, sheet, points, guide, settings, drawn,
                             TimeLeft (kept / static_cast<double> (std::max<Eigen::Index> (1, points.rows()))) },
                           folder);
    }
    catch (const Cancelled&)
    {
        tell (guide, "measurement: " + keptInWords (folder, points.rows()));
        throw;
    }
}
} // namespace antinode
