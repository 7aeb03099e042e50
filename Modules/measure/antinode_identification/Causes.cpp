#include "Causes.h"

#include "ChannelPhases.h"
#include "Channels.h"
#include "Identification.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_base/Watch.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

namespace antinode
{
namespace
{
using Complex = std::complex<double>;

/** dB: by how much a cause must lower the error to be named, and how low it must be then. */
constexpr double clearly = 4, fair = -15;

/** A corrected cause, and what is said of it. */
struct Remedy
{
    std::function<Complex (const Complex& value, double omega, Eigen::Index column)> change;
    std::string said;
};

/** Some points of responses, changed. */
FrequencyResponses remedied (const FrequencyResponses& responses, const std::vector<Eigen::Index>& points,
                             const Remedy& remedy)
{
    auto result = atPoints (responses, points);

    for (std::size_t i = 0; i < result.values.size(); ++i)
        for (std::size_t n = 0; n < points.size(); ++n)
        {
            checkWatch();
            const auto column = static_cast<Eigen::Index> (i) * responses.points.rows() + points[n];

            for (Eigen::Index f = 0; f < result.frequencies.size(); ++f)
            {
                auto& value = result.values[i](f, static_cast<Eigen::Index> (n));
                value = remedy.change (value, 2 * std::numbers::pi * result.frequencies[f], column);
            }
        }

    return result;
}

Remedy conjugated()
{
    return { [] (const Complex& value, double, Eigen::Index) { return std::conj (value); },
             "the complex conjugates of the responses fit modes: the file has the other sign of "
             "time; allowed: the convention exp (+i omega t)" };
}

/** Delays that differ from channel to channel by more than a twentieth of the highest mode's period. */
std::optional<Remedy> ownDelays (const FrequencyResponses& responses, const Eigen::MatrixXcd& residues,
                                 const Eigen::VectorXd& omega)
{
    std::vector<double> delays;

    for (Eigen::Index c = 0; c < residues.cols(); ++c)
    {
        checkWatch();
        delays.push_back (bestDelay (residues.col (c), omega).delay);
    }

    const auto [least, most] = std::minmax_element (delays.begin(), delays.end());
    const auto name = [&] (auto at) { return channelName (responses, at - delays.begin()); };

    if (delays.size() < 2 || *most - *least < 0.05 * 2 * std::numbers::pi / omega.maxCoeff())
        return {};

    return Remedy { [delays] (const Complex& value, double at, Eigen::Index column)
                    { return value * std::polar (1.0, at * delays[static_cast<std::size_t> (column)]); },
                    "delays differ from channel to channel by up to " + fixedText (micro * (*most - *least), 0)
                        + " us: " + name (most) + " is the latest, " + name (least) + " the earliest" };
}

/** Low-passes of first order in some of the channels: those whose phases they explain clearly better than none. */
std::optional<Remedy> ownLowPasses (const FrequencyResponses& responses, const Eigen::MatrixXcd& residues,
                                    const Eigen::VectorXd& omega)
{
    constexpr double better = 0.05;
    std::vector<double> corners;
    std::string named;

    for (Eigen::Index c = 0; c < residues.cols(); ++c)
    {
        checkWatch();
        const auto without = realShare (residues.col (c));
        const auto found = bestLowPass (residues.col (c), omega);
        corners.push_back (found.score > without + better ? found.corner : 0);

        if (corners.back() > 0 && named.size() < 200)
            named += (named.empty() ? "" : "; ") + channelName (responses, c) + " at "
                     + inWords (corners.back() / (2 * std::numbers::pi)) + " Hz";
    }

    if (named.empty())
        return {};

    return Remedy { [corners] (const Complex& value, double at, Eigen::Index column)
                    {
                        const auto corner = corners[static_cast<std::size_t> (column)];
                        return corner > 0 ? value * Complex (1, at / corner) : value;
                    },
                    "channels have a low-pass of first order: " + named };
}

/** Channels of the opposite sign from what the other references and points say of them. An inverted channel spoils
   tables of others too, so the worst is turned first, until none is left. */
std::optional<Remedy> inverted (const FrequencyResponses& responses, Eigen::MatrixXcd residues)
{
    const auto points = responses.points.rows(), references = residues.cols() / points;
    Eigen::VectorXd signs = Eigen::VectorXd::Ones (residues.cols());
    std::string named;

    if (references < 2 || points < 3)
        return {};

    for (Eigen::Index turned = 0; turned < residues.cols() / 2; ++turned)
    {
        Eigen::Index worst = 0;

        if (channelAgreements (residues, points).minCoeff (&worst) >= oppositeAgreement)
            break;

        residues.col (worst) *= -1;
        signs[worst] *= -1;
        named += (named.empty() ? "" : "; ") + channelName (responses, worst);
    }

    if (named.empty())
        return {};

    return Remedy { [signs] (const Complex& value, double, Eigen::Index column) { return value * signs[column]; },
                    "inverted against the other channels: " + named };
}
} // namespace

std::string likelyCause (const FrequencyResponses& responses, const IdentificationOptions& options,
                         const IdentifiedModes& modes, const Identify& identifyWith)
{
    const auto points = samplePoints (responses);
    const auto errorOf = [&] (const Remedy& remedy, const IdentificationOptions& chosen)
    {
        try
        {
            return identifyWith (remedied (responses, points, remedy), atPoints (chosen, points)).reconstructionError;
        }
        catch (const InputError&)
        {
            return std::numeric_limits<double>::infinity();
        }
    };
    const auto test = [&] (const Remedy& remedy, const IdentificationOptions& chosen, double highest)
    {
        const auto error = errorOf (remedy, chosen);
        return error < std::min (modes.reconstructionError - clearly, highest)
                   ? remedy.said + " (error then " + fixedText (error, 1) + " instead of "
                         + fixedText (modes.reconstructionError, 1) + " dB)"
                   : std::string();
    };
    const auto residues = channelResidues (responses, modes);
    const auto& omega = modes.angularFrequencies;

    if (auto said = test (conjugated(), options, fair); ! said.empty())
        return said;

    for (const auto& remedy : { inverted (responses, residues), ownDelays (responses, residues, omega),
                                ownLowPasses (responses, residues, omega) })
        if (remedy)
            if (auto said = test (*remedy, options, fair); ! said.empty())
                return said;

    auto complex = options;
    complex.complexModes = true;
    return modes.complexShapes.size() > 0
               ? std::string()
               : test ({ [] (const Complex& value, double, Eigen::Index) { return value; },
                         "complex modes describe the responses better: damping is not proportional; --complex" },
                       complex, 0);
}
} // namespace antinode
