#include "ShapeScales.h"

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
bool hasDrivingPoint (const IdentifiedModes& modes)
{
    if (modes.drive != DriveQuantity::force)
        return false;

    for (const auto& reference : modes.references)
        if (reference.point && modes.shapes.row (*reference.point).allFinite())
            return true;

    return false;
}

/** By how much a shape is to be multiplied so that alpha = phi at the driving points, by least squares, squared;
   negative where the signs contradict each other. */
double squareByDrivingPoints (const IdentifiedModes& modes, Eigen::Index mode)
{
    double between = 0, shapes = 0;

    for (std::size_t i = 0; i < modes.references.size(); ++i)
        if (const auto point = modes.references[i].point; point && std::isfinite (modes.shapes (*point, mode)))
        {
            const auto shape = modes.shapes (*point, mode);
            between += shape * modes.participation (mode, static_cast<Eigen::Index> (i));
            shapes += shape * shape;
        }

    return shapes > 0 ? between / shapes : 0;
}

double modalMass (const IdentifiedModes& modes, const Eigen::VectorXd& masses, Eigen::Index mode)
{
    double sum = 0, count = 0;

    for (Eigen::Index p = 0; p < modes.shapes.rows(); ++p)
        if (const auto shape = modes.shapes (p, mode); std::isfinite (shape))
        {
            sum += shape * shape * (masses.size() > 0 ? masses[p] : 1);
            count += 1;
        }

    return masses.size() > 0 ? sum : sum / count;
}

void scaleMode (IdentifiedModes& modes, Eigen::Index mode, double factor)
{
    modes.shapes.col (mode) *= factor;
    modes.participation.row (mode) /= factor;

    for (auto* const deviations : { &modes.deviations, &modes.noiseDeviations })
        if (deviations->shapes.size() > 0)
        {
            deviations->shapes.col (mode) *= std::abs (factor);
            deviations->participation.row (mode) /= std::abs (factor);
        }

    if (modes.complexShapes.size() > 0)
    {
        modes.complexShapes.col (mode) *= factor;
        modes.complexParticipation.row (mode) /= factor;
    }
}

double signOfLargest (const Eigen::VectorXd& shape)
{
    double largest = 0;

    for (const auto value : shape)
        if (std::isfinite (value) && std::abs (value) > std::abs (largest))
            largest = value;

    return largest < 0 ? -1 : 1;
}

void explain (IdentifiedModes& modes, const Eigen::VectorXd& masses)
{
    if (hasDrivingPoint (modes))
    {
        modes.scaling = ShapeScaling::drivingPoint;
        modes.scalingReason = "the driving point gives modal mass 1: there shape and participation are equal";
    }
    else if (masses.size() > 0)
    {
        modes.scaling = ShapeScaling::knownMass;
        modes.scalingReason = "the given masses of the points yield modal mass 1";
    }
    else
    {
        modes.scaling = ShapeScaling::convention;
        modes.scalingReason =
            "neither a driving point nor masses are known: shapes are scaled as if the points had 1 kg in "
            "total, evenly distributed; only products of shape and participation are known";
    }
}
} // namespace

void scaleShapes (IdentifiedModes& modes, const Eigen::VectorXd& masses)
{
    explain (modes, masses);

    for (Eigen::Index k = 0; k < modes.modes(); ++k)
    {
        auto square = 1 / modalMass (modes, masses, k);

        if (modes.scaling == ShapeScaling::drivingPoint)
        {
            const auto byPoint = squareByDrivingPoints (modes, k);

            if (byPoint > 0)
                square = byPoint;
            else
                modes.quality[static_cast<std::size_t> (k)].warnings.emplace_back (
                    "its response at the driving point has the wrong sign, so its scale is unknown");
        }

        scaleMode (modes, k, std::sqrt (square) * signOfLargest (modes.shapes.col (k)));
    }
}

void orthogonalise (IdentifiedModes& modes, const Eigen::VectorXd& masses)
{
    std::vector<Eigen::Index> used;

    for (Eigen::Index p = 0; p < modes.shapes.rows(); ++p)
        if (modes.shapes.row (p).allFinite())
            used.push_back (p);

    const auto points = static_cast<Eigen::Index> (used.size());
    const Eigen::VectorXd weights =
        masses.size() > 0 ? Eigen::VectorXd (masses (used)) : Eigen::VectorXd::Ones (points);
    Eigen::MatrixXd shapes = modes.shapes (used, Eigen::all);
    Eigen::MatrixXd triangle = Eigen::MatrixXd::Identity (modes.modes(), modes.modes());

    for (Eigen::Index k = 0; k < modes.modes(); ++k)
    {
        const auto length = std::sqrt (shapes.col (k).cwiseAbs2().dot (weights));

        for (Eigen::Index l = 0; l < k; ++l)
        {
            const auto square = shapes.col (l).cwiseAbs2().dot (weights);
            triangle (l, k) = shapes.col (l).cwiseProduct (weights).dot (shapes.col (k)) / std::max (square, 1e-300);
            shapes.col (k) -= triangle (l, k) * shapes.col (l);
        }

        triangle (k, k) = std::sqrt (shapes.col (k).cwiseAbs2().dot (weights)) / std::max (length, 1e-300);
        shapes.col (k) /= std::max (triangle (k, k), 1e-300);
    }

    modes.shapes (used, Eigen::all) = shapes;
    modes.participation = triangle * modes.participation;
}
} // namespace antinode
