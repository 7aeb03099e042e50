#include "Amplifier.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_model/ModalModel.h>

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace antinode
{
namespace
{
constexpr double fullTurn = 2 * std::numbers::pi;

void requireResponse (bool isRight, const std::string& what)
{
    if (! isRight)
        throw InputError ("amplifier", what);
}

/** 1 / |H|^2 = (1 + (omega T)^2) / g^2 is a line over omega^2; large responses count most, as noise is added to the
 * response. */
Amplifier byMagnitude (const Eigen::ArrayXd& omegas, const Eigen::VectorXcd& response)
{
    const Eigen::ArrayXd squares = response.cwiseAbs2().array();
    const Eigen::ArrayXd x = (omegas / omegas.maxCoeff()).square(), weights = squares.cube();
    const auto mean = [&] (const Eigen::ArrayXd& values) { return (weights * values).sum() / weights.sum(); };
    const Eigen::ArrayXd y = squares.inverse();
    const auto xMean = mean (x), yMean = mean (y);
    const auto slope = std::max (0.0, mean ((x - xMean) * (y - yMean)) / mean ((x - xMean).square()));
    const auto offset = std::max (yMean - slope * xMean, 1e-3 * yMean);
    return { 1 / std::sqrt (offset), std::sqrt (slope / offset) / omegas.maxCoeff(), 0 };
}

/** The slope of the phase that the low-pass leaves, by steps from line to line. */
double delayOf (const Eigen::ArrayXd& omegas, const Eigen::VectorXcd& response, const Amplifier& amplifier)
{
    double products = 0, squares = 0, phase = 0;
    std::complex<double> last = 1;

    for (Eigen::Index f = 0; f < omegas.size(); ++f)
    {
        const auto rest = response[f] * std::complex<double> (1, omegas[f] * amplifier.timeConstant);
        phase += std::arg (rest / last);
        last = rest;
        products += omegas[f] * phase;
        squares += omegas[f] * omegas[f];
    }

    return -products / squares;
}

/** One step of Gauss and Newton's method in the logarithm of the gain, the time constant and the delay. */
Amplifier refined (const Eigen::ArrayXd& omegas, const Eigen::VectorXcd& response, Amplifier amplifier)
{
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    // The times in units of the shortest period, or the matrix were singular to rounding.
    const auto unit = 1 / omegas.maxCoeff();

    for (Eigen::Index f = 0; f < omegas.size(); ++f)
    {
        const std::complex<double> turn (0, omegas[f] * unit);
        const auto predicted = responseOf (amplifier, omegas[f] / fullTurn);
        const auto residual = response[f] - predicted;
        const Eigen::Vector3cd by { predicted,
                                    -predicted * turn / std::complex<double> (1, omegas[f] * amplifier.timeConstant),
                                    -predicted * turn };
        matrix += (by.conjugate() * by.transpose()).real();
        right += (by.conjugate() * residual).real();
    }

    matrix.diagonal() *= 1 + 1e-12;
    const Eigen::Vector3d change = matrix.ldlt().solve (right);
    return { amplifier.gain * std::exp (std::clamp (change[0], -1.0, 1.0)),
             std::max (0.0, amplifier.timeConstant + unit * change[1]), amplifier.delay + unit * change[2] };
}

double misfitOf (const Amplifier& amplifier, const Eigen::VectorXd& frequencies, const Eigen::VectorXcd& response)
{
    double misfit = 0;

    for (Eigen::Index f = 0; f < frequencies.size(); ++f)
        misfit += std::norm (response[f] - responseOf (amplifier, frequencies[f]));

    return std::sqrt (misfit / response.squaredNorm());
}
} // namespace

std::complex<double> responseOf (const Amplifier& amplifier, double frequency)
{
    const auto omega = fullTurn * frequency;
    return std::polar (amplifier.gain, -omega * amplifier.delay)
           / std::complex<double> (1, omega * amplifier.timeConstant);
}

MeasuredAmplifier fitAmplifier (const Eigen::VectorXd& frequencies, const Eigen::VectorXcd& response)
{
    constexpr int steps = 20;
    requireResponse (frequencies.size() == response.size() && frequencies.size() >= 3, "needs 3 lines or more");
    requireResponse (response.allFinite() && response.cwiseAbs().minCoeff() > 0,
                     "gives nothing at its monitor; is it wired to that input?");
    const Eigen::ArrayXd omegas = fullTurn * frequencies;
    auto amplifier = byMagnitude (omegas, response);
    amplifier.delay = delayOf (omegas, response, amplifier);
    auto misfit = misfitOf (amplifier, frequencies, response);

    for (int i = 0; i < steps; ++i)
    {
        const auto next = refined (omegas, response, amplifier);
        const auto reached = misfitOf (next, frequencies, response);

        if (! (reached < misfit))
            break;

        amplifier = next;
        misfit = reached;
    }

    return { amplifier, misfit };
}

ModalModel throughAmplifiers (ModalModel model, const std::vector<Amplifier>& amplifiers)
{
    requireRealModes (model, "amplifiers in front of ceramics");
    requireResponse (std::ssize (amplifiers) == model.actuators(),
                     "is needed for each of the " + std::to_string (model.actuators()) + " ceramics");

    auto first = amplifiers.front().delay;

    for (const auto& amplifier : amplifiers)
        first = std::min (first, amplifier.delay);

    for (Eigen::Index i = 0; i < model.actuators(); ++i)
    {
        const auto& amplifier = amplifiers[static_cast<std::size_t> (i)];
        auto& ceramic = model.ceramics[static_cast<std::size_t> (i)];
        requireResponse (amplifier.gain > 0, "has a gain of 0 or less");
        requireResponse (amplifier.delay - first <= longestLag && amplifier.timeConstant <= longestLag,
                         "of '" + ceramic.name + "' is later than a device file can describe; allowed: up to "
                             + inWords (longestLag * 1e3) + " ms after the first one, and as long a time constant");
        requireResponse (ceramic.lag.delay == 0 && ceramic.lag.timeConstant == 0,
                         "stands in front of '" + ceramic.name
                             + "' already; allowed: the device as it was before it was calibrated");
        model.participation.col (i) *= amplifier.gain;

        // What is asked for comes out larger.
        ceramic.voltageLimit /= std::max (1.0, amplifier.gain);
        ceramic.slewLimit /= std::max (1.0, amplifier.gain);
        ceramic.lag.delay = amplifier.delay - first;
        ceramic.lag.timeConstant = amplifier.timeConstant;
    }

    return model;
}

double lateness (const Amplifier& amplifier, double frequency)
{
    const auto omega = fullTurn * frequency;
    return amplifier.delay + std::atan (omega * amplifier.timeConstant) / omega;
}
} // namespace antinode
