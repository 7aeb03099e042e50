#include "Channels.h"

#include <antinode_base/MessageText.h>
#include <antinode_base/Watch.h>
#include <antinode_numerics/Statistics.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

namespace antinode
{
namespace
{
/** Names of channels, at most a few of them. */
std::string nameChannels (const PreparedResponses& data, const std::vector<Eigen::Index>& columns)
{
    constexpr std::size_t most = 6;
    std::string text;

    for (std::size_t n = 0; n < std::min (most, columns.size()); ++n)
        text += (n > 0 ? "; " : "") + channelName (*data.responses, columns[n]);

    return columns.size() > most ? text + "; " + std::to_string (columns.size() - most) + " more" : text;
}

/** Sum over all columns of |H|^2 and of every column on its own. */
struct Energies
{
    Eigen::VectorXd lines, columns;
    bool areNoisy = false; ///< Not computed ones, in which a point at a held edge is rightly silent.
};

/** Whether lines of a response scatter, as fourth differences show: off resonance they leave nothing of a smooth one.
 */
bool isNoisy (const Eigen::VectorXcd& response)
{
    constexpr double smooth = 1e-8;
    constexpr std::array weights { 1.0, -4.0, 6.0, -4.0, 1.0 };
    std::vector<double> differences, powers;

    for (Eigen::Index f = 0; f + 4 < response.size(); ++f)
    {
        std::complex<double> difference = 0;

        for (Eigen::Index n = 0; n < 5; ++n)
            difference += weights[static_cast<std::size_t> (n)] * response[f + n];

        if (! std::isfinite (std::norm (difference)))
            continue;

        differences.push_back (std::norm (difference));
        powers.push_back (std::norm (response[f + 2]));
    }

    return ! powers.empty() && median (differences) > smooth * median (powers);
}

Energies energies (const PreparedResponses& data)
{
    constexpr Eigen::Index linesAtOnce = 256; // between looks at the watch
    Energies found { Eigen::VectorXd (data.lines()), Eigen::VectorXd::Zero (data.columns()) };

    for (Eigen::Index first = 0; first < data.lines(); first += linesAtOnce)
    {
        checkWatch();
        const auto count = std::min (linesAtOnce, data.lines() - first);
        const auto values = dataBlock (data, first, Eigen::VectorXcd::Ones (count));
        const Eigen::MatrixXd squares = values.real.cwiseAbs2() + values.imaginary.cwiseAbs2();
        found.lines.segment (first, count) = squares.rowwise().sum();
        found.columns += squares.colwise().sum().transpose();
    }

    Eigen::Index strongest = 0;
    found.columns.maxCoeff (&strongest);
    found.areNoisy = isNoisy (data.responses->values[static_cast<std::size_t> (strongest / data.points())]
                                  .col (strongest % data.points())
                                  .segment (data.firstLine, data.lines()));
    return found;
}

bool isOfMains (double frequency, double width)
{
    const auto isNear = [&] (double mains)
    {
        const auto harmonic = std::round (frequency / mains);
        return harmonic >= 1 && harmonic <= 20 && std::abs (frequency - harmonic * mains) < 0.6 * width;
    };
    return isNear (50) || isNear (60);
}

/** A line that stands alone. A resonance, even one that lines do not resolve, lifts its neighbours too: beside it power
   falls to a quarter from line to line. */
bool isSpike (const Eigen::VectorXd& power, Eigen::Index line)
{
    constexpr double times = 9, skirt = 2;
    return power[line] > times * std::max (power[line - 1], power[line + 1])
           && power[line - 1] < skirt * power[line - 2] && power[line + 1] < skirt * power[line + 2];
}

/** All values of a line begin as what lies between its neighbours, and follow the fit. */
void leaveOutLine (PreparedResponses& data, Eigen::Index line)
{
    const Eigen::VectorXcd ones = Eigen::VectorXcd::Ones (1);
    const auto before = dataBlock (data, line - 1, ones), after = dataBlock (data, line + 1, ones);
    std::vector<MissingValue> values;

    for (Eigen::Index c = 0; c < data.columns(); ++c)
        if (data.columnWeights[c] > 0)
            values.push_back ({ line,
                                c,
                                { (before.real (0, c) + after.real (0, c)) / 2,
                                  (before.imaginary (0, c) + after.imaginary (0, c)) / 2 } });

    std::erase_if (data.missing, [line] (const auto& value) { return value.line == line; });
    const auto place = std::lower_bound (data.missing.begin(), data.missing.end(), line,
                                         [] (const auto& value, Eigen::Index at) { return value.line < at; });
    data.missing.insert (place, values.begin(), values.end());
}

std::string leaveOutMains (PreparedResponses& data, const Eigen::VectorXd& power)
{
    std::string frequencies;

    for (Eigen::Index f = 2; f + 2 < data.lines(); ++f)
    {
        const auto frequency = data.omega[f] / (2 * std::numbers::pi);
        const auto width = (data.omega[f + 1] - data.omega[f - 1]) / (4 * std::numbers::pi);

        if (! isOfMains (frequency, width) || ! isSpike (power, f))
            continue;

        leaveOutLine (data, f);
        frequencies += (frequencies.empty() ? "" : ", ") + fixedText (frequency, 0);
    }

    return frequencies;
}
} // namespace

std::string channelName (const FrequencyResponses& responses, Eigen::Index column)
{
    const auto points = responses.points.rows();
    const auto point = "point " + std::to_string (column % points + 1);
    return responses.references.size() == 1
               ? point
               : point + ", driver " + responses.references[static_cast<std::size_t> (column / points)].name;
}

std::vector<std::string> leaveOutDisturbed (PreparedResponses& data)
{
    constexpr double silent = 1e-12; // of the median channel's energy
    std::vector<std::string> said;
    const auto found = energies (data);
    std::vector<double> active;

    for (Eigen::Index c = 0; c < data.columns(); ++c)
        if (data.columnWeights[c] > 0)
            active.push_back (found.columns[c]);

    const auto typical = median (active);
    std::vector<Eigen::Index> dead;

    for (Eigen::Index c = 0; c < data.columns(); ++c)
        if (found.areNoisy && data.columnWeights[c] > 0 && found.columns[c] < silent * typical)
            dead.push_back (c);

    for (const auto c : dead)
        data.columnWeights[c] = 0;

    if (! dead.empty())
        said.push_back ("without signal, hence left out: " + nameChannels (data, dead));

    if (const auto frequencies = leaveOutMains (data, found.lines); ! frequencies.empty())
        said.push_back ("single lines of the mains are left out: " + frequencies + " Hz");

    return said;
}

std::vector<std::string> weighDownMisfits (PreparedResponses& data, const FitErrors& errors)
{
    constexpr double overNoise = 4, overOthers = 10, share = 0.03;
    const Eigen::VectorXd error = errors.energies.colwise().sum().transpose();
    const Eigen::VectorXd noise = errors.roughness.colwise().sum().transpose();
    const Eigen::VectorXd energies = errors.dataEnergies.cwiseMax (1e-300);
    const Eigen::VectorXd relative = error.cwiseQuotient (energies), relativeNoise = noise.cwiseQuotient (energies);
    std::vector<double> active, activeNoise;

    for (Eigen::Index c = 0; c < data.columns(); ++c)
        if (data.columnWeights[c] > 0)
        {
            active.push_back (relative[c]);
            activeNoise.push_back (relativeNoise[c]);
        }

    if (active.size() < 3)
        return {};

    const auto typical = median (active), typicalNoise = median (activeNoise);
    std::vector<Eigen::Index> poor, noisy;

    for (Eigen::Index c = 0; c < data.columns(); ++c)
    {
        const auto stands = [&] (double value, double ofOthers)
        { return data.columnWeights[c] > 0 && value > std::max (share, overOthers * ofOthers); };

        if (error[c] > overNoise * noise[c] && stands (relative[c], typical))
        {
            data.columnWeights[c] *= typical / relative[c];
            poor.push_back (c);
        }
        else if (stands (relativeNoise[c], typicalNoise))
            noisy.push_back (c);
    }

    std::vector<std::string> said;

    if (! poor.empty())
        said.push_back ("does not follow the modes of the others, hence counts for little: "
                        + nameChannels (data, poor));

    if (! noisy.empty())
        said.push_back ("much noisier than the others, hence counts for little: " + nameChannels (data, noisy));

    return said;
}
} // namespace antinode
