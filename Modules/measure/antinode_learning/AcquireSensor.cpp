#include "AcquireSensor.h"

#include "LowerRate.h"
#include "PlayedVoltages.h"

#include <antinode_base/Watch.h>
#include <antinode_focus/SpillOver.h>
#include <antinode_numerics/Fourier.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace antinode
{
namespace
{
/** Of a parabola through three values at -1, 0 and 1: where its extreme is. */
double extremeOf (double before, double middle, double after)
{
    const auto curvature = before - 2 * middle + after;
    return curvature == 0 ? 0 : std::clamp ((before - after) / (2 * curvature), -0.5, 0.5);
}

/** A signal, and what the lowest modes make of the voltages that were played meanwhile. */
class Correlations
{
public:
    Correlations (const ModalModel& lowest, const Eigen::RowVectorXd& shapesToUse, const PlayedRecording& recording,
                  double memory, double longest)
        : model (lowest), shapes (shapesToUse), rate (recording.sampleRate), samples (recording.voltages.cols()),
          lags (std::min (samples, static_cast<Eigen::Index> (std::ceil (longest * rate)) + 1)),
          first (std::min (samples, static_cast<Eigen::Index> (std::ceil (memory * rate)))),
          length (quickLength (static_cast<double> (samples + lags))),
          forces (PlayedVoltages (recording.voltages, rate).forces (model.participation))
    {
        Eigen::VectorXd signal = recording.signals.row (0).transpose();
        signal.head (first).setZero();
        norm = signal.norm();
        heard = tables.forward (signal, length);
    }

    /** By how much all frequencies are off: the delay that explains most, to a fraction of a sample.
        @param finer  into how many parts a sample is divided */
    AcquiredSensor at (double logarithm, Eigen::Index finer)
    {
        checkWatch();
        const auto predicted = predict (logarithm);

        if (! predicted.any() || ! (norm > 0))
            return {};

        const Eigen::VectorXcd spectrum = tables.forward (predicted, length).conjugate().cwiseProduct (heard);
        Eigen::VectorXcd padded = Eigen::VectorXcd::Zero (finer * length / 2 + 1);
        padded.head (spectrum.size()) = static_cast<double> (finer) * spectrum;
        const auto products = tables.inverse (padded, finer * length);
        Eigen::Index best = 0;
        const auto searched = finer * (lags - 1) + 1;
        products.head (searched).cwiseAbs().maxCoeff (&best);
        best = earlierAlike (products.head (searched), best,
                             static_cast<Eigen::Index> (std::llround (apart * rate * static_cast<double> (finer))));
        const auto near = [&] (Eigen::Index lag) { return products[(lag + products.size()) % products.size()]; };
        const auto delay = static_cast<double> (best) + extremeOf (near (best - 1), near (best), near (best + 1));
        const auto product = std::abs (products[best]);
        const auto energy = energyOf (predicted, best / finer);
        // Frequencies that are a little off lower the product, what is not modelled raises the norm.
        const auto scale = std::sqrt (product / energy * norm / std::sqrt (energy));
        return { std::max (0.0, delay) / (rate * static_cast<double> (finer)), std::copysign (scale, products[best]),
                 logarithm, std::min (1.0, product / (norm * std::sqrt (energy))) };
    }

private:
    static constexpr double apart = 0.05; // s: less is another period of the same mode

    /** What is played again and again is heard one period later as well: of delays that explain alike the shortest. */
    static Eigen::Index earlierAlike (const Eigen::VectorXd& products, Eigen::Index best, Eigen::Index distance)
    {
        constexpr double alike = 0.95;

        while (best > distance)
        {
            Eigen::Index earlier = 0;

            if (products.head (best - distance).cwiseAbs().maxCoeff (&earlier) < alike * std::abs (products[best]))
                break;

            best = earlier;
        }

        return best;
    }

    /** Of what is compared at a delay, samples. */
    double energyOf (const Eigen::VectorXd& predicted, Eigen::Index delay) const
    {
        const auto begin = std::max<Eigen::Index> (0, first - delay);
        const auto count = std::max<Eigen::Index> (1, samples - delay - begin);
        return std::max (predicted.segment (begin, count).squaredNorm(), 1e-300);
    }

    Eigen::VectorXd predict (double logarithm) const
    {
        Eigen::VectorXd predicted = Eigen::VectorXd::Zero (samples);

        for (Eigen::Index k = 0; k < model.modes(); ++k)
            predicted += shapes[k]
                         * modeMotion (model.angularFrequencies[k] * std::exp (logarithm), model.dampingRatios[k],
                                       forces.col (k), rate, samples, false)
                               .velocity;

        predicted.head (std::max<Eigen::Index> (0, first - lags)).setZero();
        return predicted;
    }

    const ModalModel& model;
    Eigen::RowVectorXd shapes;
    double rate;
    Eigen::Index samples, lags, first, length;
    Eigen::MatrixXd forces;
    FourierTables tables;
    Eigen::VectorXcd heard; // spectrum of the compared part, the rest silent
    double norm = 0;
};

/** Those that explain nearly as much as the best, each at a delay of its own.
    @param apart  s: delays that differ by less are the same */
std::vector<AcquiredSensor> likeliest (std::vector<AcquiredSensor> found, double apart)
{
    constexpr double nearly = 0.9;
    constexpr std::size_t most = 4;
    std::sort (found.begin(), found.end(), [] (const auto& a, const auto& b) { return a.explained > b.explained; });
    std::vector<AcquiredSensor> likely;

    for (const auto& sensor : found)
    {
        const auto isSame = [&] (const AcquiredSensor& other) { return std::abs (other.delay - sensor.delay) < apart; };

        if (likely.size() < most && sensor.explained >= nearly * found.front().explained
            && std::none_of (likely.begin(), likely.end(), isSame))
            likely.push_back (sensor);
    }

    return likely;
}
} // namespace

std::vector<AcquiredSensor> likelySensors (const ModalModel& nominal, const Eigen::RowVectorXd& shapes,
                                           const PlayedRecording& recording, const DriftSettings& settings,
                                           double longest)
{
    constexpr Eigen::Index finer = 8;
    const auto model = firstModes (nominal, modesForSearch (nominal));
    Correlations correlations (model, shapes.head (model.modes()), atLowerRate (recording, highestModelled (model)),
                               settings.memory, longest);
    // Halfway between steps of the jump search the wrong delay explains more.
    constexpr double parts = 4;
    const auto step = jumpStep (nominal, settings) / parts;
    const auto steps = std::lround (settings.largestJump / step);
    std::vector<AcquiredSensor> found;

    for (auto i = -steps; i <= steps; ++i)
        if (const auto sensor = correlations.at (static_cast<double> (i) * step, 1); sensor.explained > 0)
            found.push_back (sensor);

    auto likely = likeliest (std::move (found), std::numbers::pi / (2 * model.angularFrequencies[model.modes() - 1]));

    for (auto& sensor : likely)
        sensor = correlations.at (sensor.jump, finer);

    return likely;
}
} // namespace antinode
