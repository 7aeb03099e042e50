#include "WindowedResponses.h"

#include <antinode_base/Watch.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

namespace antinode
{
namespace
{
constexpr Eigen::Index linesPerBlock = 256; // that stay in the cache together

/** H H^H + lambda of some lines: column p + points q. */
Eigen::MatrixXcd gramLines (const PointResponses& responses, Eigen::Index first, Eigen::Index count, double compliance)
{
    const auto points = responses.points;
    const auto lines = responses.values.middleRows (first, count);
    Eigen::MatrixXcd gram = Eigen::MatrixXcd::Zero (count, points * points);

    for (Eigen::Index q = 0; q < points; ++q)
    {
        for (Eigen::Index p = q; p < points; ++p)
        {
            auto sum = gram.col (p + points * q);

            for (Eigen::Index i = 0; i < responses.actuators; ++i)
                sum.array() += lines.col (p + points * i).array() * lines.col (q + points * i).array().conjugate();

            gram.col (q + points * p) = sum.conjugate();
        }

        gram.col (q + points * q).array() += compliance;
    }

    return gram;
}

/** The inverses of Hermitian, positive definite matrices, one a row: Gauss's and Jordan's elimination of all at once,
    which needs no pivots for these. */
void invertLines (Eigen::MatrixXcd& matrices, Eigen::Index points)
{
    const auto at = [&] (Eigen::Index p, Eigen::Index q) { return matrices.col (p + points * q).array(); };

    for (Eigen::Index k = 0; k < points; ++k)
    {
        const Eigen::ArrayXcd pivot = at (k, k).real().inverse().cast<std::complex<double>>();

        for (Eigen::Index q = 0; q < points; ++q)
        {
            if (q == k)
                continue;

            const Eigen::ArrayXcd scaled = at (k, q) * pivot;

            for (Eigen::Index p = 0; p < points; ++p)
                if (p != k)
                    at (p, q) -= at (p, k) * scaled;

            at (k, q) = scaled;
        }

        for (Eigen::Index p = 0; p < points; ++p)
            if (p != k)
                at (p, k) *= -pivot;

        at (k, k) = pivot;
    }
}

Eigen::MatrixXcd preconditioner (const PointResponses& responses, double compliance, std::size_t threads)
{
    const auto lines = responses.values.rows();
    Eigen::MatrixXcd inverses (lines, responses.points * responses.points);

    const auto ofBlock = [&] (std::size_t block)
    {
        checkWatch();
        const auto first = static_cast<Eigen::Index> (block) * linesPerBlock;
        const auto count = std::min (linesPerBlock, lines - first);
        auto matrices = gramLines (responses, first, count, compliance);
        invertLines (matrices, responses.points);
        inverses.middleRows (first, count) = matrices;
    };
    parallelFor (static_cast<std::size_t> ((lines + linesPerBlock - 1) / linesPerBlock), ofBlock, threads);
    return inverses;
}

/** One a thread. */
std::vector<std::unique_ptr<FourierTables>> fourierTables (std::size_t threads)
{
    std::vector<std::unique_ptr<FourierTables>> tables;

    for (std::size_t i = 0; i < threads; ++i)
        tables.push_back (std::make_unique<FourierTables>());

    return tables;
}

/** The window of a stage: it rises after the stage before and falls until the next one, as a sine and a cosine, so that
    the squares of all add to 1. */
Eigen::VectorXd stageWindow (const std::vector<Eigen::Index>& stages, std::size_t stage, Eigen::Index length)
{
    const auto quarter = [] (Eigen::Index n, Eigen::Index from, Eigen::Index to)
    { return std::numbers::pi / 2 * static_cast<double> (n - from) / static_cast<double> (to - from); };
    const auto at = stages[stage];
    Eigen::VectorXd window = Eigen::VectorXd::Zero (length);
    const auto begin = stage > 0 ? stages[stage - 1] : 0, end = stage + 1 < stages.size() ? stages[stage + 1] : length;

    for (auto n = begin; n < end; ++n)
        if (n < at)
            window[n] = stage > 0 ? std::sin (quarter (n, begin, at)) : 1;
        else
            window[n] = stage + 1 < stages.size() ? std::cos (quarter (n, at, end)) : 1;

    return window;
}
} // namespace

PointResponses frozenResponses (const PointResponses& nodes, const MovingPoints& moving, Eigen::Index sample)
{
    PointResponses frozen { moving.points.back() + 1, nodes.actuators, nodes.length, nodes.sampleRate, {} };
    frozen.values = Eigen::MatrixXcd::Zero (nodes.values.rows(), frozen.points * frozen.actuators);

    for (Eigen::Index i = 0; i < nodes.actuators; ++i)
        for (Eigen::Index node = 0; node < nodes.points; ++node)
            frozen.values.col (moving.points[static_cast<std::size_t> (node)] + frozen.points * i) +=
                moving.weights (sample, node) * nodes.values.col (node + nodes.points * i);

    return frozen;
}

WindowedResponses::WindowedResponses (PointResponses responsesToUse, Eigen::Index windowToUse, double compliance,
                                      MovingPoints movingToUse, std::size_t threads)
    : responses (std::move (responsesToUse)), moving (std::move (movingToUse)), window (windowToUse),
      lambda (compliance), tables (fourierTables (threads)), inverses (stageInverses())
{
}

std::vector<Eigen::MatrixXcd> WindowedResponses::stageInverses() const
{
    if (moving.points.empty())
        return { preconditioner (responses, lambda, tables.size()) };

    std::vector<Eigen::MatrixXcd> all;

    for (const auto sample : moving.stages)
        all.push_back (preconditioner (frozenResponses (responses, moving, sample), lambda, tables.size()));

    return all;
}

void WindowedResponses::setCompliance (double compliance)
{
    lambda = compliance;
    inverses = stageInverses();
}

/** Every table is used by one thread: signal i by that of i modulo their number. */
void WindowedResponses::forEach (Eigen::Index count, const std::function<void (Eigen::Index, FourierTables&)>& work)
{
    parallelFor (
        tables.size(),
        [&] (std::size_t stripe)
        {
            for (auto i = static_cast<Eigen::Index> (stripe); i < count; i += static_cast<Eigen::Index> (tables.size()))
            {
                checkWatch();
                work (i, *tables[stripe]);
            }
        },
        tables.size());
}

Eigen::MatrixXcd WindowedResponses::spectra (const Eigen::MatrixXd& signalsToTransform)
{
    Eigen::MatrixXcd result (length() / 2 + 1, signalsToTransform.cols());
    forEach (result.cols(), [&] (Eigen::Index i, FourierTables& table)
             { result.col (i) = table.forward (signalsToTransform.col (i), length()); });
    return result;
}

template <typename Term>
Eigen::MatrixXd WindowedResponses::combined (const Eigen::MatrixXd& signals, Eigen::Index count, Eigen::Index rows,
                                             const Term& term)
{
    const auto lines = spectra (signals);
    Eigen::MatrixXd result (rows, count);
    forEach (count,
             [&] (Eigen::Index to, FourierTables& table)
             {
                 Eigen::VectorXcd sum = Eigen::VectorXcd::Zero (lines.rows());

                 for (Eigen::Index from = 0; from < lines.cols(); ++from)
                     sum.array() += term (to, from) * lines.col (from).array();

                 result.col (to) = table.inverse (sum, length()).head (rows);
             });
    return result;
}

Eigen::MatrixXd WindowedResponses::motion (const Eigen::MatrixXd& voltages)
{
    auto all = combined (voltages, responses.points, length(),
                         [this] (Eigen::Index p, Eigen::Index i)
                         { return responses.values.col (p + responses.points * i).array(); });

    if (moving.points.empty())
        return all;

    Eigen::MatrixXd result = Eigen::MatrixXd::Zero (length(), points());

    for (Eigen::Index node = 0; node < all.cols(); ++node)
        result.col (moving.points[static_cast<std::size_t> (node)]) +=
            moving.weights.col (node).cwiseProduct (all.col (node));

    return result;
}

Eigen::MatrixXd WindowedResponses::pulls (const Eigen::MatrixXd& multipliers)
{
    const auto toActuators = [this] (Eigen::Index i, Eigen::Index p)
    { return responses.values.col (p + responses.points * i).array().conjugate(); };

    if (moving.points.empty())
        return combined (multipliers, actuators(), window, toActuators);

    Eigen::MatrixXd spread (length(), responses.points);

    for (Eigen::Index node = 0; node < spread.cols(); ++node)
        spread.col (node) =
            moving.weights.col (node).cwiseProduct (multipliers.col (moving.points[static_cast<std::size_t> (node)]));

    return combined (spread, actuators(), window, toActuators);
}

Eigen::MatrixXd WindowedResponses::stageInverse (const Eigen::MatrixXd& right, const Eigen::MatrixXcd& inverse)
{
    return combined (right, points(), length(),
                     [&] (Eigen::Index p, Eigen::Index q) { return inverse.col (p + points() * q).array(); });
}

Eigen::MatrixXd WindowedResponses::precondition (const Eigen::MatrixXd& right)
{
    if (inverses.size() == 1)
        return stageInverse (right, inverses.front());

    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero (right.rows(), right.cols());

    for (std::size_t stage = 0; stage < inverses.size(); ++stage)
    {
        const Eigen::VectorXd share = stageWindow (moving.stages, stage, length());
        sum += share.asDiagonal() * stageInverse (share.asDiagonal() * right, inverses[stage]);
    }

    return sum;
}
} // namespace antinode
