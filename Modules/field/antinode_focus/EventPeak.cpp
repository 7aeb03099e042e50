#include "EventPeak.h"

#include "PeakSearch.h"

#include <antinode_base/Watch.h>
#include <antinode_numerics/DenseKernels.h>
#include <antinode_numerics/KaiserSinc.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace antinode
{
namespace
{
constexpr double samplesPerPeriod = 4;                          // of the highest mode
constexpr double lineEventDensity = 1, plateEventDensity = 0.5; // at least 3 places per wave of the highest mode
constexpr double promisingCrest = 0.8;
constexpr std::size_t maximumEventStarts = 32, maximumCrests = 20000;
constexpr Eigen::Index columnsAtOnce = 128;

Eigen::Index sampleStride (const ModalModel& model, double sampleRate)
{
    const auto highest = model.angularFrequencies[model.modes() - 1] / (2 * std::numbers::pi);
    return std::max<Eigen::Index> (1, static_cast<Eigen::Index> (sampleRate / (samplesPerPeriod * highest)));
}

/** Whether a value is a crest of its own sign: neighbours of the other sign may be larger. */
bool isCrest (double value, double before, double after)
{
    const auto sign = value < 0 ? -1.0 : 1.0;
    return value != 0 && sign * value >= sign * before && sign * value >= sign * after;
}

/** Crests in time at all places, of those that may become the largest. */
class Crests
{
public:
    Crests (const SearchPlaces& placesToUse, double intervalToUse) : places (placesToUse), interval (intervalToUse) {}

    /** @param velocities  places x columns, of which the first and the last are looked at as neighbours only */
    void add (const Eigen::MatrixXd& velocities, Eigen::Index firstStep)
    {
        for (Eigen::Index c = 1; c + 1 < velocities.cols(); ++c)
        {
            const auto column = velocities.col (c).cwiseAbs();
            const auto bound = promisingCrest * (largest = std::max (largest, column.maxCoeff()));

            for (Eigen::Index i = 0; i < column.size(); ++i)
                if (column[i] >= bound && isCrest (velocities (i, c), velocities (i, c - 1), velocities (i, c + 1)))
                    take (i, interval * static_cast<double> (firstStep + c), velocities (i, c));
        }
    }

    const std::vector<PeakStart>& all() const { return crests; }

private:
    void take (Eigen::Index place, double time, double velocity)
    {
        if (crests.size() == maximumCrests)
        {
            const auto size = [] (const PeakStart& start) { return std::abs (start.at.velocity); };
            std::nth_element (crests.begin(), crests.begin() + maximumCrests / 2, crests.end(),
                              [&] (const PeakStart& a, const PeakStart& b) { return size (a) > size (b); });
            crests.resize (maximumCrests / 2);
        }

        auto start = places.starts[static_cast<std::size_t> (place)];
        start.at.time = time;
        start.at.velocity = velocity;
        crests.push_back (start);
    }

    const SearchPlaces& places;
    double interval; // s
    double largest = 0;
    std::vector<PeakStart> crests;
};

/** Every so many samples; before the first and after the last of them nothing moves. */
Eigen::MatrixXd everyStride (const Eigen::MatrixXd& samples, Eigen::Index first, Eigen::Index stride,
                             Eigen::Index begin, Eigen::Index count, Eigen::Index steps)
{
    Eigen::MatrixXd columns = Eigen::MatrixXd::Zero (samples.rows(), count);

    for (Eigen::Index c = 0; c < count; ++c)
        if (const auto step = begin + c; step >= 0 && step < steps)
            columns.col (c) = samples.col (first + step * stride);

    return columns;
}

/** The top next to one sample. */
SamplePeak crestBetween (const Eigen::MatrixXd& row, const FieldPeak& sample)
{
    const auto last = static_cast<double> (row.cols() - 1);
    const auto sign = sample.velocity < 0 ? -1.0 : 1.0;
    const auto valueAt = [&] (const Eigen::VectorXd& at)
    { return betweenSamples (row, std::clamp (at[0], 0.0, last))[0]; };
    const auto top = climb ([&] (const Eigen::VectorXd& at) { return sign * valueAt (at); },
                            Eigen::VectorXd::Constant (1, sample.time), Eigen::VectorXd::Constant (1, 0.5));
    return { std::clamp (top[0], 0.0, last), valueAt (top) };
}
} // namespace

Eigen::VectorXd betweenSamples (const Eigen::MatrixXd& samples, double position)
{
    const auto nearest = std::clamp<Eigen::Index> (std::llround (position), 0, samples.cols() - 1);

    if (position == static_cast<double> (nearest))
        return samples.col (nearest);

    // At the ends, where samples are missing, the weights still add up to 1.
    const auto begin = std::max<Eigen::Index> (0, nearest - kaiserSincHalfWidth);
    const auto end = std::min<Eigen::Index> (samples.cols(), nearest + kaiserSincHalfWidth + 1);
    Eigen::VectorXd weights (end - begin);

    for (Eigen::Index n = begin; n < end; ++n)
        weights[n - begin] = kaiserSinc (position - static_cast<double> (n));

    return samples.middleCols (begin, end - begin) * weights / weights.sum();
}

SamplePeak largestInTime (const Eigen::RowVectorXd& samples)
{
    constexpr double possible = 0.5; // of the largest sample: a crest of three samples per period may have lost half
    constexpr std::size_t most = 64;
    const Eigen::MatrixXd row = samples;
    std::vector<PeakStart> crests;

    for (Eigen::Index n = 0; n < samples.size(); ++n)
        if (isCrest (samples[n], samples[std::max<Eigen::Index> (0, n - 1)],
                     samples[std::min (samples.size() - 1, n + 1)]))
            crests.push_back ({ { 0, 0, static_cast<double> (n), samples[n] }, -1, 0 });

    SamplePeak largest;

    for (const auto& crest : chooseStarts (std::move (crests), { 0, 0, 0.4 }, possible, most))
    {
        const auto peak = crestBetween (row, crest.at);

        if (std::abs (peak.value) > std::abs (largest.value))
            largest = peak;
    }

    return largest;
}

FieldPeak largestInEvent (const ModalModel& model, const RecordedMotion& motion, const std::vector<FocalSpot>& outside,
                          Eigen::Index first, Eigen::Index last)
{
    const auto isLine = model.surface.kind == SurfaceKind::line;
    auto places = searchPlaces (model, isLine ? lineEventDensity : plateEventDensity, outside);

    // Wide targets cover the whole surface.
    if (places.starts.empty())
        return {};

    const auto stride = std::min (sampleStride (model, motion.sampleRate), std::max<Eigen::Index> (1, last - first));
    const auto steps = (last - first) / stride + 1;
    places.steps.time = static_cast<double> (stride) / motion.sampleRate;
    Crests crests (places, places.steps.time);

    for (Eigen::Index begin = -1; begin < steps; begin += columnsAtOnce - 2)
    {
        Eigen::MatrixXd velocities = Eigen::MatrixXd::Zero (places.shapes.rows(), columnsAtOnce);
        addProduct (velocities, 1, places.shapes,
                    everyStride (motion.modalVelocities, first, stride, begin, columnsAtOnce, steps));
        crests.add (velocities, begin);
    }

    const auto begin = static_cast<double> (first) / motion.sampleRate;
    auto starts = chooseStarts (crests.all(), places.steps, promisingCrest, maximumEventStarts);

    for (auto& start : starts)
        start.at.time += begin;

    const auto velocity = [&] (double x, double y, double time)
    { return shapesAt (model, x, y).dot (betweenSamples (motion.modalVelocities, time * motion.sampleRate)); };
    return climbToPeak (velocity, starts, places.steps,
                        { model.surface, outside, begin, static_cast<double> (last) / motion.sampleRate });
}
} // namespace antinode
