#include "CircularPlates.h"

#include <Eigen/Dense>
#include <antinode_numerics/Quadrature.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace antinode::tests
{
namespace
{
/** The deflection, slope, moment and Kirchhoff's shear force of one solution at a radius, each by D. */
using EdgeValues = Eigen::Vector4d;

/** With f and df/dr, and the Laplacian that is sign k^2 f: J and Y have -1, I and K have 1. */
EdgeValues edgeValues (double f, double slope, double sign, double k, int n, double radius, double poissonRatio)
{
    const auto laplacian = sign * k * k * f;
    const auto tangential = slope / radius - n * n * f / (radius * radius);
    const auto moment = laplacian - (1 - poissonRatio) * tangential;
    const auto shear =
        sign * k * k * slope - (1 - poissonRatio) * n * n / radius * (slope / radius - f / (radius * radius));
    return { f, slope, moment, shear };
}

/** Values and derivatives of J, I, Y and K, the growing and falling ones by their values at a radius of the ring. */
Eigen::Matrix4d ringValues (const PlateRing& ring, double k, int n, double radius, double scaleRadius)
{
    const auto z = k * radius, scale = k * scaleRadius;
    const auto derivative = [&] (auto function, double sign)
    { return k * ((n == 0 ? 0.0 : n * function (n, z) / z) + sign * function (n + 1, z)); };
    const auto j = [] (int m, double x) { return std::cyl_bessel_j (m, x); };
    const auto y = [] (int m, double x) { return std::cyl_neumann (m, x); };
    const auto i = [] (int m, double x) { return std::cyl_bessel_i (m, x); };
    const auto kk = [] (int m, double x) { return std::cyl_bessel_k (m, x); };
    const auto iScale = i (n, scale), kScale = kk (n, scale),
               yScale = std::abs (y (n, scale)) + std::abs (j (n, scale));
    Eigen::Matrix4d values;
    values.col (0) = edgeValues (j (n, z), derivative (j, -1), -1, k, n, radius, ring.poissonRatio);
    values.col (1) = edgeValues (i (n, z) / iScale, derivative (i, 1) / iScale, 1, k, n, radius, ring.poissonRatio);
    values.col (2) = edgeValues (y (n, z) / yScale, derivative (y, -1) / yScale, -1, k, n, radius, ring.poissonRatio);
    values.col (3) = edgeValues (kk (n, z) / kScale, derivative (kk, -1) / kScale, 1, k, n, radius, ring.poissonRatio);
    return values;
}

double waveNumber (const PlateRing& ring, double angularFrequency)
{
    return std::sqrt (angularFrequency * std::sqrt (ring.massPerArea / ring.stiffness));
}

/** The conditions at an edge: two rows for the solutions of its ring. @param side  1 outside, -1 inside */
Eigen::Matrix<double, 2, 4> edgeRows (const CircularEdge& edge, const PlateRing& ring, const Eigen::Matrix4d& values,
                                      double side)
{
    Eigen::Matrix<double, 2, 4> rows;
    rows.row (0) =
        edge.translation >= rigid
            ? values.row (0)
            : Eigen::RowVector4d (side * ring.stiffness * values.row (3) - edge.translation * values.row (0));
    rows.row (1) = edge.rotation >= rigid
                       ? values.row (1)
                       : Eigen::RowVector4d (ring.stiffness * values.row (2) + side * edge.rotation * values.row (1));
    return rows;
}

/** Of all rings: conditions x solutions, J and I alone about a centre. */
Eigen::MatrixXd conditions (const CircularPlate& plate, double angularFrequency, int n)
{
    const auto hasCentre = plate.hole == 0;
    const auto rings = static_cast<Eigen::Index> (plate.rings.size());
    const Eigen::Index size = 4 * rings - (hasCentre ? 2 : 0);
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero (size, size);
    Eigen::Index row = 0, column = 0;

    for (Eigen::Index r = 0; r < rings; ++r)
    {
        const auto& ring = plate.rings[static_cast<std::size_t> (r)];
        const auto k = waveNumber (ring, angularFrequency);
        const auto inner = r > 0 ? plate.rings[static_cast<std::size_t> (r - 1)].outerRadius : plate.hole;
        const Eigen::Index solutions = r == 0 && hasCentre ? 2 : 4;
        const Eigen::Vector4d byStiffness (1, 1, ring.stiffness, ring.stiffness);

        if (r > 0)
        {
            const Eigen::Matrix4d values = byStiffness.asDiagonal() * ringValues (ring, k, n, inner, ring.outerRadius);
            matrix.block (row - 4, column, 4, solutions) = -values.leftCols (solutions);
        }
        else if (! hasCentre)
        {
            matrix.block (0, 0, 2, 4) =
                edgeRows (plate.inner, ring, ringValues (ring, k, n, inner, ring.outerRadius), -1);
            row = 2;
        }

        const auto values = ringValues (ring, k, n, ring.outerRadius, ring.outerRadius);

        if (r + 1 < rings)
        {
            matrix.block (row, column, 4, solutions) = (byStiffness.asDiagonal() * values).leftCols (solutions);
            row += 4;
        }
        else
            matrix.block (row, column, 2, solutions) = edgeRows (plate.outer, ring, values, 1).leftCols (solutions);

        column += solutions;
    }

    return matrix;
}

double determinant (const CircularPlate& plate, double angularFrequency, int n)
{
    // With many nodal diameters solutions differ by many powers of ten: only signs are wanted.
    auto matrix = conditions (plate, angularFrequency, n);

    for (int pass = 0; pass < 3; ++pass)
        for (Eigen::Index i = 0; i < matrix.rows(); ++i)
        {
            matrix.col (i) /= matrix.col (i).cwiseAbs().maxCoeff();
            matrix.row (i) /= matrix.row (i).cwiseAbs().maxCoeff();
        }

    return matrix.fullPivLu().determinant();
}

double bisect (const CircularPlate& plate, double low, double high, int n)
{
    auto below = determinant (plate, low, n);

    for (int i = 0; i < 60; ++i)
    {
        const auto middle = (low + high) / 2;
        const auto value = determinant (plate, middle, n);
        ((value > 0) == (below > 0) ? low : high) = middle;
    }

    return (low + high) / 2;
}
} // namespace

std::vector<CircularMode> circularModes (const CircularPlate& plate, int count)
{
    const auto& outer = plate.rings.back();
    const auto unit = std::sqrt (outer.stiffness / outer.massPerArea) / (outer.outerRadius * outer.outerRadius);
    std::vector<CircularMode> modes;

    for (double limit = 2.5 * count + 100;; limit *= 1.5)
    {
        modes.clear();

        for (int n = 0; n < 4 + 2 * std::sqrt (limit); ++n)
        {
            constexpr double step = 0.02; // Of the wave number by the radius: closer roots do not occur.
            auto before = determinant (plate, 0.0025 * unit, n);

            for (double root = 0.05 + step; root * root < limit; root += step)
            {
                const auto value = determinant (plate, root * root * unit, n);

                if ((value > 0) != (before > 0))
                {
                    const auto frequency = bisect (plate, std::pow (root - step, 2) * unit, root * root * unit, n);
                    modes.insert (modes.end(), n == 0 ? 1 : 2, { frequency, n });
                }

                before = value;
            }
        }

        std::sort (modes.begin(), modes.end(),
                   [] (const auto& a, const auto& b) { return a.angularFrequency < b.angularFrequency; });

        if (static_cast<int> (modes.size()) >= count)
        {
            modes.resize (static_cast<std::size_t> (count));
            return modes;
        }
    }
}

double slopeAtFirstRing (const CircularPlate& plate, double angularFrequency)
{
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd (conditions (plate, angularFrequency, 0), Eigen::ComputeFullV);
    const Eigen::VectorXd solution = svd.matrixV().rightCols<1>();
    const auto rule = gaussLegendre (40, 4);
    Eigen::Index column = 0;
    double mass = 0, slope = 0;

    for (std::size_t r = 0; r < plate.rings.size(); ++r)
    {
        const auto& ring = plate.rings[r];
        const auto k = waveNumber (ring, angularFrequency);
        const auto inner = r > 0 ? plate.rings[r - 1].outerRadius : plate.hole;
        const Eigen::Index solutions = r == 0 && plate.hole == 0 ? 2 : 4;
        const Eigen::VectorXd own = solution.segment (column, solutions);
        const auto at = [&] (double radius, Eigen::Index row)
        { return ringValues (ring, k, 0, radius, ring.outerRadius).row (row).leftCols (solutions).dot (own); };

        for (Eigen::Index i = 0; i < rule.nodes.size(); ++i)
        {
            const auto radius = inner + (ring.outerRadius - inner) * rule.nodes[i];
            mass += rule.weights[i] * (ring.outerRadius - inner) * 2 * std::numbers::pi * radius * ring.massPerArea
                    * std::pow (at (radius, 0), 2);
        }

        if (r == 0)
            slope = at (ring.outerRadius, 1);

        column += solutions;
    }

    return slope / std::sqrt (mass);
}
} // namespace antinode::tests
