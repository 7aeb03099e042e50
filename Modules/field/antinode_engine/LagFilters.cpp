#include "LagFilters.h"

#include "VoltageLimiter.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_model/ModalModel.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace antinode
{
namespace
{
constexpr double fullTurn = 2 * std::numbers::pi;

/** From a bit below the lowest mode to a bit above the highest one, as far as samples can tell it. */
FitBand bandOf (const ModalModel& model, double sampleRate)
{
    constexpr double below = 0.8, above = 1.1, mostOfNyquist = 0.9;
    const auto perSample = fullTurn / sampleRate;
    const auto highest =
        std::min (above * perSample * model.frequencyHz (model.modes() - 1), mostOfNyquist * std::numbers::pi);
    return { std::min (below * perSample * model.frequencyHz (0), highest / 2), highest };
}

double longestDelay (const ModalModel& model)
{
    double longest = 0;

    for (const auto& ceramic : model.ceramics)
        longest = std::max (longest, ceramic.lag.delay);

    if (longest > longestLag)
        throw InputError ("lag", "delays of ceramics differ by " + inWords (longest * 1e3) + " ms; allowed: up to "
                                     + inWords (longestLag * 1e3) + " ms");

    return longest;
}

/** What a ceramic's filter is to do beside half its length and a delay of whole samples. */
FitTarget targetOf (const InputLag& lag, double sampleRate, LagDirection direction, double partOfSample)
{
    const auto isApplied = direction == LagDirection::apply;
    return { sampleRate * lag.timeConstant, isApplied, isApplied ? -lag.angle : lag.angle, partOfSample };
}

LagFilters filtersOf (const ModalModel& model, double sampleRate, LagDirection direction, const TapFit& fit)
{
    const auto latest = std::ceil (longestDelay (model) * sampleRate);
    LagFilters filters;
    filters.lateness = fit.half() + (direction == LagDirection::undo ? static_cast<Eigen::Index> (latest) : 0);
    filters.taps.resize (2 * fit.half() + 1, model.actuators());

    for (Eigen::Index i = 0; i < model.actuators(); ++i)
    {
        const auto& lag = model.ceramics[static_cast<std::size_t> (i)].lag;
        const auto delay = direction == LagDirection::undo ? latest - sampleRate * lag.delay : sampleRate * lag.delay;
        const auto whole = std::round (delay);
        const auto target = targetOf (lag, sampleRate, direction, delay - whole);
        const auto taps = fit.taps (target);
        filters.misfit = std::max (filters.misfit, fit.misfit (taps, target));
        filters.taps.col (i) = taps.reverse();
        filters.starts.push_back (static_cast<Eigen::Index> (whole));
    }

    return filters;
}

/** All outputs of all samples, and what goes on after the last one.
    @param earlier  samples by which the result is shifted
    @return         samples x N_b */
Eigen::MatrixXd filtered (const LagFilters& filters, const Eigen::MatrixXd& voltages, Eigen::Index earlier,
                          Eigen::Index length)
{
    Eigen::MatrixXd result (length, voltages.rows());
    const auto taps = filters.taps.rows();

    for (Eigen::Index i = 0; i < voltages.rows(); ++i)
    {
        const auto before = filters.starts[static_cast<std::size_t> (i)] + taps - 1 - earlier;
        Eigen::VectorXd padded = Eigen::VectorXd::Zero (before + std::max (voltages.cols(), length + earlier));
        padded.segment (before, voltages.cols()) = voltages.row (i);

        for (Eigen::Index n = 0; n < length; ++n)
            result (n, i) = filters.taps.col (i).dot (padded.segment (n, taps));
    }

    return result;
}

/** How many samples of each column limits have changed, by more than rounding does. */
std::vector<std::int64_t> changedSamples (const Eigen::MatrixXd& before, const Eigen::MatrixXd& after,
                                          const Eigen::VectorXd& limits)
{
    constexpr double rounding = 1e-9; // of the limit
    std::vector<std::int64_t> counts;

    for (Eigen::Index i = 0; i < before.cols(); ++i)
        counts.push_back (((after.col (i) - before.col (i)).cwiseAbs().array() > rounding * limits[i]).count());

    return counts;
}

void requireRows (const ModalModel& model, const Eigen::MatrixXd& voltages)
{
    if (voltages.rows() != model.actuators())
        throw InputError ("voltages", "have " + std::to_string (voltages.rows()) + " channels; allowed: "
                                          + std::to_string (model.actuators()) + ", one per ceramic");
}
} // namespace

Eigen::Index LagFilters::reach() const
{
    return taps.rows() + *std::max_element (starts.begin(), starts.end());
}

bool needsLagFilters (const ModalModel& model)
{
    const auto& ceramics = model.ceramics;
    return std::any_of (ceramics.begin(), ceramics.end(),
                        [&] (const Ceramic& ceramic)
                        {
                            const auto& lag = ceramic.lag;
                            return lag.timeConstant != 0 || lag.angle != 0 || lag.delay != ceramics.front().lag.delay;
                        });
}

LagFilters lagFilters (const ModalModel& model, double sampleRate, LagDirection direction)
{
    constexpr Eigen::Index shortest = 24, longest = 512; // half a filter
    constexpr double goodEnough = 0.001;
    const auto band = bandOf (model, sampleRate);

    for (auto half = shortest;; half = std::min (2 * half, longest))
        if (auto filters = filtersOf (model, sampleRate, direction, TapFit (band, half));
            filters.misfit < goodEnough || half == longest)
            return filters;
}

UndoneLags withLagsUndone (const ModalModel& model, const Eigen::MatrixXd& voltages, const Eigen::VectorXd& limits,
                           double sampleRate)
{
    if (! needsLagFilters (model))
        return { voltages };

    requireRows (model, voltages);
    const auto filters = lagFilters (model, sampleRate, LagDirection::undo);
    auto asked = filtered (filters, voltages, 0, voltages.cols() + filters.reach());
    std::vector<double*> channels;

    for (Eigen::Index i = 0; i < asked.cols(); ++i)
        channels.push_back (asked.col (i).data());

    const auto count = static_cast<int> (asked.rows());
    const Eigen::MatrixXd unlimited = asked;
    SlewLimiter (limits, slewLimits (model), sampleRate).process (channels.data(), channels.data(), count);
    VoltageLimiter (limits).process (channels.data(), count);
    return { asked.transpose(), changedSamples (unlimited, asked, limits), filters.lateness, filters.misfit };
}

Eigen::MatrixXd withLags (const ModalModel& model, const Eigen::MatrixXd& voltages, double sampleRate)
{
    if (! needsLagFilters (model))
        return voltages;

    requireRows (model, voltages);
    const auto filters = lagFilters (model, sampleRate, LagDirection::apply);
    return filtered (filters, voltages, filters.lateness, voltages.cols()).transpose();
}

TapFit::TapFit (const FitBand& band, Eigen::Index half)
    : highest (band.highest), bandLines (6 * half), omegas (bandLines + 4 * half)
{
    constexpr double weightAnywhere = 1e-4; // so that taps stay small where nothing is said of the response
    const auto anywhere = omegas.size() - bandLines;
    omegas << Eigen::ArrayXd::LinSpaced (bandLines, band.lowest, band.highest),
        Eigen::ArrayXd::LinSpaced (anywhere, 0, std::numbers::pi);
    weights.setConstant (omegas.size(), 1.0 / static_cast<double> (bandLines));
    weights.tail (anywhere) = weightAnywhere / static_cast<double> (anywhere);
    const Eigen::RowVectorXd times = Eigen::RowVectorXd::LinSpaced (half, 1, static_cast<double> (half));
    const Eigen::ArrayXXd angles = (omegas.matrix() * times).array();
    even.resize (angles.rows(), half + 1);
    even << Eigen::VectorXd::Ones (angles.rows()), 2 * angles.cos().matrix();
    odd = -2 * angles.sin().matrix();
    evenFactor = factorOf (even);
    oddFactor = factorOf (odd);
}

Eigen::LLT<Eigen::MatrixXd> TapFit::factorOf (const Eigen::MatrixXd& waves) const
{
    constexpr double ridge = 1e-12;
    Eigen::MatrixXd matrix = waves.transpose() * weights.matrix().asDiagonal() * waves;
    matrix.diagonal() *= 1 + ridge;
    return Eigen::LLT<Eigen::MatrixXd> (matrix);
}

Eigen::ArrayXcd TapFit::wanted (const FitTarget& target) const
{
    const std::complex<double> unit (0, 1);
    const Eigen::ArrayXcd lead = 1.0 + unit * target.timeConstant * omegas.min (highest);
    const Eigen::ArrayXcd turned = (unit * (target.angle - omegas * target.delay)).exp();
    return target.isLowPass ? Eigen::ArrayXcd (turned / lead) : Eigen::ArrayXcd (lead * turned);
}

Eigen::VectorXd TapFit::taps (const FitTarget& target) const
{
    const auto response = wanted (target);
    const Eigen::VectorXd evens = evenFactor.solve (even.transpose() * (weights * response.real()).matrix());
    const Eigen::VectorXd odds = oddFactor.solve (odd.transpose() * (weights * response.imag()).matrix());
    Eigen::VectorXd all (2 * half() + 1);
    all << (evens.tail (half()) - odds).reverse(), evens[0], evens.tail (half()) + odds;
    return all;
}

double TapFit::misfit (const Eigen::VectorXd& taps, const FitTarget& target) const
{
    const Eigen::VectorXd after = taps.tail (half()), before = taps.head (half()).reverse();
    Eigen::VectorXd evens (half() + 1);
    evens << taps[half()], (after + before) / 2;
    Eigen::ArrayXcd response (omegas.size());
    response.real() = (even * evens).array();
    response.imag() = (odd * (after - before) / 2).array();
    const auto right = wanted (target);
    return ((response - right) / right).head (bandLines).abs().maxCoeff();
}
} // namespace antinode
