#include "TouchedNodes.h"

#include <antinode_base/Watch.h>
#include <antinode_numerics/DenseKernels.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

namespace antinode
{
namespace
{
constexpr double placeSpacing = 5e-4;  // m
constexpr Eigen::Index leastSteps = 3; // of a polynomial of third order
} // namespace

std::vector<PathShapes::Leg> PathShapes::legsOf (const TouchedPoint& point)
{
    std::vector<Leg> legs;
    Eigen::Index count = 0;

    for (std::size_t i = 1; i < point.path.size(); ++i)
    {
        const auto &from = point.path[i - 1], &to = point.path[i];
        const auto length = std::hypot (to.x - from.x, to.y - from.y);
        const auto steps = std::max (leastSteps, static_cast<Eigen::Index> (std::ceil (length / placeSpacing)));
        legs.push_back ({ from.time, to.time, count, steps });
        count += steps + 1;
    }

    return legs;
}

Eigen::Index PathShapes::placesAlong (const TouchedPoint& point)
{
    const auto legs = legsOf (point);
    return legs.empty() ? 1 : legs.back().first + legs.back().steps + 1;
}

PathShapes::PathShapes (const ModalModel& model, const TouchedPoint& point)
    : legs (legsOf (point)), table (model.coordinates(), placesAlong (point))
{
    if (legs.empty())
    {
        const auto place = placeAt (point, 0);
        table = shapesAt (model, place.x, place.y).transpose();
    }

    for (const auto& leg : legs)
        for (Eigen::Index i = 0; i <= leg.steps; ++i)
        {
            checkWatch();
            const auto share = static_cast<double> (i) / static_cast<double> (leg.steps);
            const auto place = placeAt (point, leg.begin + share * (leg.end - leg.begin));
            table.col (leg.first + i) = shapesAt (model, place.x, place.y).transpose();
        }
}

Eigen::VectorXd PathShapes::at (double time) const
{
    if (legs.empty() || time <= legs.front().begin)
        return table.col (0);

    if (time >= legs.back().end)
        return table.col (table.cols() - 1);

    const auto& leg = *std::find_if (legs.begin(), legs.end(), [&] (const Leg& one) { return time < one.end; });
    const auto at = (time - leg.begin) / (leg.end - leg.begin) * static_cast<double> (leg.steps);
    const auto first = std::clamp<Eigen::Index> (static_cast<Eigen::Index> (at) - 1, 0, leg.steps - leastSteps);
    const auto u = at - static_cast<double> (first);

    // Lagrange's polynomials of the places 0, 1, 2 and 3.
    const Eigen::Vector4d weights { -(u - 1) * (u - 2) * (u - 3) / 6, u * (u - 2) * (u - 3) / 2,
                                    -u * (u - 1) * (u - 3) / 2, u * (u - 1) * (u - 2) / 6 };
    return table.middleCols<leastSteps + 1> (leg.first + first) * weights;
}

std::vector<PathShapes> pathShapes (const ModalModel& model, const WaveformsDescription& description)
{
    requirePlaces (model.surface, description);
    std::vector<PathShapes> paths;

    for (const auto& point : touchedPoints (description))
        paths.emplace_back (model, point);

    return paths;
}

namespace
{
constexpr double leastMotion = 1e-5; // of the largest along a path: what nodes leave out
constexpr double stageStep = 5e-3;   // m, after which the preconditioner takes other responses
constexpr int mostStageSteps = 31;   // with longer steps if need be: each stage takes memory

/** How far a ceramic moves each mode at most at frequencies up to half a rate: what an error of its shape is worth. */
Eigen::VectorXd importances (const ModalModel& model, double sampleRate)
{
    const auto highest = std::numbers::pi * sampleRate; // rad/s
    Eigen::VectorXd worth = model.participation.rowwise().norm();

    for (Eigen::Index k = 0; k < worth.size(); ++k)
    {
        const auto own = model.angularFrequencies[k];
        const auto resonant = 2 * model.dampingRatios[k] * own * std::min (own, highest);
        worth[k] /= own > highest ? std::hypot (own * own - highest * highest, resonant) : resonant;
    }

    // Modes that no ceramic moves are worth next to nothing, but not nothing: shapes are divided by it.
    constexpr double least = 1e-12, smallest = 1e-200;
    return worth.cwiseMax (std::max (least * worth.maxCoeff(), smallest));
}

/** The singular vectors of shapes along a path that are worth anything: factors N_m x nodes for shapes at any place of
    it, and what they are the factors of, nodes x N_m. */
std::pair<Eigen::MatrixXd, Eigen::MatrixXd> pathNodes (const Eigen::MatrixXd& places, const Eigen::VectorXd& worth)
{
    Eigen::MatrixXd gram = Eigen::MatrixXd::Zero (places.rows(), places.rows());
    addGram (gram, 1, Eigen::MatrixXd (worth.asDiagonal() * places));
    const auto eigen = symmetricEigen (gram);
    const auto least = leastMotion * leastMotion * eigen.values[eigen.values.size() - 1];
    const Eigen::MatrixXd vectors = eigen.vectors.rightCols ((eigen.values.array() > least).count());
    return { worth.asDiagonal() * vectors, vectors.transpose() * worth.cwiseInverse().asDiagonal() };
}
} // namespace

TouchedNodes::TouchedNodes (const ModalModel& model, const WaveformsDescription& description, double sampleRate)
    : paths (pathShapes (model, description)), fits (paths.size()),
      stageTimes (timesOfPlaces (description, stageStep, mostStageSteps))
{
    std::vector<Eigen::MatrixXd> shapes;

    for (std::size_t p = 0; p < paths.size(); ++p)
    {
        checkWatch();
        shapes.emplace_back (paths[p].places().col (0).transpose());

        if (paths[p].moves())
        {
            requireRealModes (model, "waveforms at moving points");
            std::tie (fits[p], shapes.back()) = pathNodes (paths[p].places(), importances (model, sampleRate));
        }

        points.insert (points.end(), static_cast<std::size_t> (shapes.back().rows()), static_cast<Eigen::Index> (p));
    }

    nodes.resize (static_cast<Eigen::Index> (points.size()), shapes.front().cols());
    Eigen::Index row = 0;

    for (const auto& some : shapes)
    {
        nodes.middleRows (row, some.rows()) = some;
        row += some.rows();
    }
}

MovingPoints TouchedNodes::weights (double sampleRate, Eigen::Index lead, Eigen::Index length) const
{
    MovingPoints moving;

    if (std::none_of (paths.begin(), paths.end(), [] (const auto& path) { return path.moves(); }))
        return moving;

    moving.points = points;
    moving.weights = Eigen::MatrixXd::Ones (length, nodes.rows());

    for (const auto time : stageTimes)
        moving.stages.push_back (std::clamp<Eigen::Index> (std::llround (time * sampleRate) + lead, 0, length - 1));

    moving.stages.erase (std::unique (moving.stages.begin(), moving.stages.end()), moving.stages.end());

    Eigen::Index first = 0;

    for (std::size_t p = 0; p < paths.size(); first += std::max<Eigen::Index> (1, fits[p].cols()), ++p)
        for (Eigen::Index n = 0; n < length && paths[p].moves(); ++n)
        {
            const auto time = static_cast<double> (n - lead) / sampleRate;
            moving.weights.row (n).segment (first, fits[p].cols()) = paths[p].at (time).transpose() * fits[p];
        }

    return moving;
}
} // namespace antinode
