#include "IdentificationTables.h"

#include <antinode_base/MessageText.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace antinode
{
namespace
{
constexpr double percent = 100, partsPerMillion = 1e6;
constexpr const char* plusMinus = " \xC2\xB1 ";

/** Value and deviation with as many decimals as show two digits of the deviation. */
std::string withDeviation (double value, double deviation, int fewest)
{
    constexpr int maximum = 9;
    const auto isKnown = deviation > 0 && std::isfinite (deviation);
    const auto decimals =
        isKnown ? std::clamp (1 - static_cast<int> (std::floor (std::log10 (deviation))), fewest, maximum) : fewest;
    return fixedText (value, decimals) + (isKnown ? plusMinus + fixedText (deviation, decimals) : "");
}

double valueAt (const Eigen::VectorXd& values, Eigen::Index index)
{
    return index < values.size() ? values[index] : 0;
}

/** Characters of UTF-8, each of which takes a column. */
std::size_t countCharacters (const std::string& text)
{
    return static_cast<std::size_t> (
        std::count_if (text.begin(), text.end(), [] (char byte) { return (byte & 0xc0) != 0x80; }));
}
std::string joined (const std::vector<std::string>& texts, const std::string& between)
{
    std::string all;

    for (const auto& text : texts)
        all += (all.empty() ? "" : between) + text;

    return all;
}

std::vector<std::string> modeWarnings (const IdentificationResult& result)
{
    std::vector<std::string> warnings;

    for (std::size_t k = 0; k < result.modes.quality.size(); ++k)
        for (const auto& warning : result.modes.quality[k].warnings)
            warnings.push_back ("Mode " + std::to_string (k + 1) + ": " + warning);

    return warnings;
}

/** What was said about files, then about the identification, then these about modes, then about the device. */
std::vector<std::string> withGeneralWarnings (const IdentificationResult& result,
                                              const std::vector<std::string>& ofModes)
{
    auto warnings = result.remarks;
    warnings.insert (warnings.end(), result.modes.warnings.begin(), result.modes.warnings.end());
    warnings.insert (warnings.end(), ofModes.begin(), ofModes.end());
    const auto all = modeWarnings (result);

    for (const auto& warning : result.model.warnings)
        if (std::find (warnings.begin(), warnings.end(), warning) == warnings.end()
            && std::find (all.begin(), all.end(), warning) == all.end())
            warnings.push_back (warning);

    return warnings;
}
} // namespace

std::string scalingInWords (const IdentifiedModes& modes)
{
    const std::string size = modes.scaling == ShapeScaling::drivingPoint
                                 ? "The scale of the shapes follows from a driving point"
                             : modes.scaling == ShapeScaling::knownMass
                                 ? "The scale of the shapes follows from the known mass"
                                 : "The scale of the shapes is a convention: only products of shape and "
                                   "participation are known";
    return size + (modes.scalingReason.empty() ? "." : " (" + modes.scalingReason + ").");
}

std::string delayInWords (const IdentifiedModes& modes)
{
    return withDeviation (partsPerMillion * modes.delay, partsPerMillion * modes.deviations.delay, 3);
}

ReportTable modeTable (const IdentificationResult& result)
{
    const auto& modes = result.modes;
    ReportTable table { "Modes",
                        { "mode", "frequency (Hz)", "damping ratio (%)", "MPC", "one shape", "signal to noise (dB)" },
                        {} };

    for (Eigen::Index k = 0; k < modes.modes(); ++k)
    {
        const auto quality = static_cast<std::size_t> (k) < modes.quality.size()
                                 ? modes.quality[static_cast<std::size_t> (k)]
                                 : ModeQuality {};
        const auto hertz = 1 / (2 * std::numbers::pi);
        table.rows.push_back (
            { std::to_string (k + 1),
              withDeviation (hertz * modes.angularFrequencies[k],
                             hertz * valueAt (modes.deviations.angularFrequencies, k), 2),
              withDeviation (percent * modes.dampingRatios[k], percent * valueAt (modes.deviations.dampingRatios, k),
                             3),
              fixedText (quality.collinearity, 4), fixedText (quality.rankOne, 4),
              quality.signalToNoise > 0 ? fixedText (20 * std::log10 (quality.signalToNoise), 1) : "" });
    }

    return table;
}

ReportTable pairTable (const IdentificationResult& result)
{
    const auto& computed = *result.computed;
    ReportTable table { "Identified and computed modes",
                        { "identified", "computed", "identified (Hz)", "computed (Hz)", "difference (ppm)", "MAC" },
                        {} };

    for (const auto& pair : result.comparison->pairs)
        table.rows.push_back (
            { std::to_string (pair.identified + 1), std::to_string (pair.computed + 1),
              fixedText (result.modes.angularFrequencies[pair.identified] / (2 * std::numbers::pi), 3),
              fixedText (computed.frequencyHz (pair.computed), 3),
              fixedText (partsPerMillion * pair.relativeDifference, 1), fixedText (pair.assurance, 5) });

    return table;
}

std::string tableText (const ReportTable& table)
{
    std::vector<std::size_t> widths;

    for (std::size_t c = 0; c < table.header.size(); ++c)
    {
        widths.push_back (countCharacters (table.header[c]));

        for (const auto& row : table.rows)
            widths[c] = std::max (widths[c], countCharacters (row[c]));
    }

    std::string text;
    const auto add = [&] (const std::vector<std::string>& row)
    {
        for (std::size_t c = 0; c < row.size(); ++c)
            text += std::string (widths[c] - countCharacters (row[c]) + (c > 0 ? 2 : 0), ' ') + row[c];

        text += '\n';
    };
    add (table.header);

    for (const auto& row : table.rows)
        add (row);

    return text;
}

std::string sizeInWords (const IdentificationResult& result)
{
    const auto& modes = result.modes;
    return std::to_string (modes.modes()) + " modes from " + std::to_string (result.measured.points.rows())
           + " points and " + std::to_string (result.measured.references.size()) + " references, "
           + inWords (modes.minimumFrequency) + " to " + inWords (modes.maximumFrequency) + " Hz";
}

std::vector<std::string> warningColumn (const IdentificationResult& result)
{
    std::vector<std::string> column;

    for (const auto& quality : result.modes.quality)
        column.push_back (joined (quality.warnings, "; "));

    return column;
}

std::vector<std::string> summariseWarnings (const IdentificationResult& result)
{
    constexpr std::size_t fewest = 4; // Fewer are said one by one.
    const auto column = warningColumn (result);
    std::vector<std::string> numbers;

    for (std::size_t k = 0; k < column.size(); ++k)
        if (! column[k].empty())
            numbers.push_back (std::to_string (k + 1));

    return withGeneralWarnings (
        result, numbers.size() < fewest
                    ? modeWarnings (result)
                    : std::vector { std::to_string (numbers.size()) + " of " + std::to_string (column.size())
                                    + " modes have warnings, which the table of modes gives: " + joined (numbers, ", ")
                                    + "." });
}

std::vector<std::string> collectWarnings (const IdentificationResult& result)
{
    return withGeneralWarnings (result, modeWarnings (result));
}
} // namespace antinode
