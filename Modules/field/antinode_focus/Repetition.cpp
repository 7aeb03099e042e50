#include "Repetition.h"

#include "DriveAllocation.h"
#include "Prediction.h"

#include <antinode_base/Watch.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace antinode
{
namespace
{
constexpr double longestPeriod = 60; // s
constexpr int stepsPerCycle = 8;     // of the periods looked at, in the highest frequency
constexpr int samplesPerStep = gridSamplesPerCycle / stepsPerCycle;
constexpr double negligible = 1e-3; // of what may be left: later repeats add no more, and no mode that adds less counts
constexpr double limitTolerance = 1e-6;
constexpr Eigen::Index samplesAtOnce = 4096; // between two looks at the watch

/** Looks at one period after the other. */
class Repetition
{
public:
    Repetition (const ModalModel& modelToUse, const VoltageProgram& programToUse, const std::vector<double>& timesToUse)
        : model (modelToUse), program (programToUse), times (timesToUse), motion (model, program),
          reach (model.modes()), decay (decayRates (model))
    {
        const auto frequency = dampedFrequencies (model);
        toVelocity = Eigen::VectorXcd::Ones (model.modes());
        toVelocity.imag() = decay.cwiseQuotient (frequency);

        for (Eigen::Index k = 0; k < reach.size(); ++k)
            reach[k] = model.shapes.col (k).cwiseAbs().maxCoeff() * std::abs (toVelocity[k]);

        double highest = 1;

        for (const auto& oscillation : program.oscillations)
            highest = std::max (highest, oscillation.angularFrequency / (2 * std::numbers::pi));

        step = 1 / (highest * stepsPerCycle);

        for (const auto time : times)
            allowed.push_back (
                repetitionLoss
                * (model.shapes * modalVelocities (model, motion.statesAt (time))).cwiseAbs().maxCoeff());

        sampleVoltages();
    }

    std::optional<double> shortest() const
    {
        auto steps = certainlyEnough();

        if (! steps)
            return {};

        while (*steps > 1 && isWithoutLoss (*steps - 1))
            --*steps;

        return static_cast<double> (*steps) * step;
    }

private:
    /** Steps of a period so long that no phase of any mode matters, which is easily found since what is left then only
        falls. */
    std::optional<std::int64_t> certainlyEnough() const
    {
        const Eigen::VectorXd left = motion.statesAt (motion.last()).cwiseAbs().cwiseProduct (reach);
        const auto isEnough = [&] (double period)
        {
            for (std::size_t j = 0; j < times.size(); ++j)
            {
                const Eigen::ArrayXd decayed = (-decay * (times[j] + period - motion.last())).array().exp();
                const Eigen::ArrayXd repeats = 1 - (-decay * period).array().exp();

                if (! ((left.array() * decayed / repeats).sum() <= allowed[j]))
                    return false;
            }

            return true;
        };
        auto low = motion.last() - motion.first(), high = low;

        while (high <= longestPeriod && ! isEnough (high))
        {
            low = high;
            high *= 2;
        }

        if (high > longestPeriod)
            return {};

        while (high - low > step)
            (isEnough (0.5 * (low + high)) ? high : low) = 0.5 * (low + high);

        return static_cast<std::int64_t> (std::ceil (high / step));
    }

    bool isWithoutLoss (std::int64_t steps) const
    {
        const auto period = static_cast<double> (steps) * step;

        for (std::size_t j = 0; j < times.size(); ++j)
            if (! leavesEnough (period, times[j], allowed[j]))
                return false;

        return keepsLimits (steps * samplesPerStep);
    }

    /** Whether all others leave a focus alone, in a train of any length and at any place of it. */
    bool leavesEnough (double period, double time, double maximum) const
    {
        Eigen::VectorXcd later = Eigen::VectorXcd::Zero (model.modes());

        for (int n = 1; time - n * period > motion.first(); ++n)
            later += motion.statesAt (time - n * period);

        const auto isFirstFree = amplitude (later, maximum) <= maximum;
        return isFirstFree && staysWithin (Eigen::VectorXcd::Zero (model.modes()), period, time, maximum)
               && (later.isZero (0) || staysWithin (later, period, time, maximum));
    }

    /** Whether the states and what more and more earlier repeats add to them stay within an amplitude. */
    bool staysWithin (Eigen::VectorXcd states, double period, double time, double maximum) const
    {
        const Eigen::ArrayXd repeats = 1 - (-decay * period).array().exp();
        auto reached = amplitude (states, maximum);

        for (auto t = time + period;; t += period)
        {
            const auto more = motion.statesAt (t);
            const Eigen::ArrayXd sizes = more.cwiseAbs().cwiseProduct (reach).array();

            if (t > motion.last() && reached + (sizes / repeats).sum() <= maximum)
                return true;

            states += more;
            reached = reached + sizes.sum() <= maximum ? reached + sizes.sum() : amplitude (states, maximum);

            if (reached > maximum)
                return false;

            if (t > motion.last() && (sizes / repeats).sum() < negligible * maximum)
                return true;
        }
    }

    /** The largest amplitude of the velocity anywhere on the surface, whatever the phase; a bound of it where that is
        at most `most`. */
    double amplitude (const Eigen::VectorXcd& states, double maximum) const
    {
        const Eigen::VectorXd sizes = states.cwiseAbs().cwiseProduct (reach);
        const auto bound = sizes.sum();

        if (bound <= maximum)
            return bound;

        Eigen::ArrayXd real = Eigen::ArrayXd::Zero (model.points()), imaginary = real;

        for (Eigen::Index k = 0; k < sizes.size(); ++k)
            if (sizes[k] > negligible * maximum / static_cast<double> (sizes.size()))
            {
                const auto velocity = states[k] * toVelocity[k];
                real += velocity.real() * model.shapes.col (k).array();
                imaginary += velocity.imag() * model.shapes.col (k).array();
            }

        return std::sqrt ((real.square() + imaginary.square()).maxCoeff());
    }

    /** All voltages as shares of their limits, on a grid that every period looked at is made of. */
    void sampleVoltages()
    {
        const auto interval = step / samplesPerStep;
        const auto count = static_cast<Eigen::Index> (std::ceil ((motion.last() - motion.first()) / interval)) + 1;
        const Eigen::MatrixXd perLimit = program.voltageLimits.cwiseInverse().asDiagonal() * program.allocation;
        voltages = Eigen::MatrixXd::Zero (perLimit.rows(), count);

        for (std::size_t c = 0; c < program.oscillations.size(); ++c)
        {
            checkWatch();
            const auto& oscillation = program.oscillations[c];
            const auto place = [&] (double time)
            { return static_cast<Eigen::Index> (std::max (0.0, std::floor ((time - motion.first()) / interval))); };

            const auto last = std::min (place (oscillation.end), count - 1);

            for (auto n = place (oscillation.start); n <= last; ++n)
            {
                if (n % samplesAtOnce == 0)
                    checkWatch();

                voltages.col (n) += oscillationValue (oscillation, motion.first() + static_cast<double> (n) * interval)
                                    * perLimit.col (static_cast<Eigen::Index> (c));
            }
        }

        peaks = voltages.cwiseAbs().colwise().maxCoeff();
    }

    /** Whether sums of overlapping repeats keep the limits, or, where a single program does not, its own peak. */
    bool keepsLimits (Eigen::Index period) const
    {
        const auto count = voltages.cols();
        const auto maximum = std::max (gridLimitMargin(), peaks.maxCoeff()) + limitTolerance;

        for (Eigen::Index n = 0; n < std::min (period, count - period); ++n)
        {
            double peak = 0;

            if (n % samplesAtOnce == 0)
                checkWatch();

            for (auto m = n; m < count; m += period)
                peak += peaks[m];

            if (peak <= maximum)
                continue;

            Eigen::VectorXd sum = voltages.col (n);

            for (auto m = n + period; m < count; m += period)
                sum += voltages.col (m);

            if (sum.cwiseAbs().maxCoeff() > maximum)
                return false;
        }

        return true;
    }

    const ModalModel& model;
    const VoltageProgram& program;
    const std::vector<double>& times;
    ProgramMotion motion;
    Eigen::VectorXd reach;       // the largest velocity of each mode anywhere on the surface per |y|
    Eigen::VectorXd decay;       // 1/s
    Eigen::VectorXcd toVelocity; // 1 + j a/b
    double step = 0;             // s
    std::vector<double> allowed; // m/s, a focus
    Eigen::MatrixXd voltages;    // N_b x samples, of the limits
    Eigen::VectorXd peaks;       // the largest of each sample
};
} // namespace

std::optional<double> shortestPeriod (const ModalModel& model, const VoltageProgram& program,
                                      const std::vector<double>& times)
{
    return Repetition (model, program, times).shortest();
}
} // namespace antinode
