#include "ErrorMap.h"

#include <antinode_base/NumberText.h>
#include <antinode_base/Watch.h>

#include <algorithm>
#include <cmath>
#include <complex>

namespace antinode
{
namespace
{
constexpr Eigen::Index spans = 24;

double decibels (double ratio)
{
    return 10 * std::log10 (std::max (ratio, 1e-30));
}

/** Energies of velocities and of what synthesis leaves of them, by spans of lines and by channels: spans x C. */
struct ErrorMap
{
    Eigen::VectorXd edges; ///< Hz, spans + 1.
    Eigen::ArrayXXd errors, energies;
};

ErrorMap errorMap (const FrequencyResponses& responses, const IdentifiedModes& modes, const FrequencyBand& band)
{
    const auto* const begin = responses.frequencies.data();
    const auto* const end = begin + responses.frequencies.size();
    const auto first = std::lower_bound (begin, end, band.minimum) - begin;
    const auto count = std::upper_bound (begin, end, band.maximum) - begin - first;
    const auto points = responses.points.rows();
    ErrorMap map { Eigen::VectorXd (spans + 1),
                   Eigen::ArrayXXd::Zero (spans, points * static_cast<Eigen::Index> (responses.values.size())),
                   {} };
    map.energies = map.errors;
    map.edges[spans] = responses.frequencies[first + count - 1];

    for (Eigen::Index s = 0; s < spans; ++s)
    {
        checkWatch();
        const auto from = first + s * count / spans, lines = first + (s + 1) * count / spans - from;
        map.edges[s] = responses.frequencies[from];

        const auto given = synthesise (modes, responses.frequencies.segment (from, lines));

        for (std::size_t i = 0; i < responses.values.size(); ++i)
            for (Eigen::Index p = 0; p < points; ++p)
                for (Eigen::Index f = 0; f < lines; ++f)
                {
                    const auto measured = responses.values[i](from + f, p);
                    const auto column = static_cast<Eigen::Index> (i) * points + p;

                    if (const auto error = std::norm (measured - given.values[i](f, p)); std::isfinite (error))
                    {
                        map.errors (s, column) += error;
                        map.energies (s, column) += std::norm (measured);
                    }
                }
    }

    return map;
}

} // namespace

double errorBetween (const FrequencyResponses& responses, const IdentifiedModes& modes, const FrequencyBand& band)
{
    const auto map = errorMap (responses, modes, band);
    const Eigen::ArrayXd errors = map.errors.rowwise().sum(), energies = map.energies.rowwise().sum();
    return decibels (errors.sum() / energies.sum()) + decibels ((errors / energies.max (1e-300)).min (1).mean());
}

std::string sayWhere (const FrequencyResponses& responses, const IdentifiedModes& modes)
{
    const auto map = errorMap (responses, modes, { modes.minimumFrequency, modes.maximumFrequency });
    const Eigen::ArrayXd bySpan = map.errors.rowwise().sum(), byColumn = map.errors.colwise().sum().transpose();
    Eigen::Index span = 0, column = 0;
    bySpan.maxCoeff (&span);
    byColumn.maxCoeff (&column);
    const auto share = [] (double part, double all)
    { return fixedText (100 * part / std::max (all, 1e-300), 0) + " %"; };
    auto text = share (bySpan[span], bySpan.sum()) + " of the error lies from " + inWords (map.edges[span]) + " to "
                + inWords (map.edges[span + 1]) + " Hz";

    if (byColumn.size() > 1)
        text += ", " + share (byColumn[column], byColumn.sum()) + " of it at point "
                + std::to_string (column % responses.points.rows() + 1) + ", driver "
                + responses.references[static_cast<std::size_t> (column / responses.points.rows())].name;

    return text
           + "; other ranges and orders were tried: check quantity, sign and sensors, then --band, --orders and "
             "--complex";
}
} // namespace antinode
