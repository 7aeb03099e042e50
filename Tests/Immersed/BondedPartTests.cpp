#include <antinode_numerics/Quadrature.h>
#include <antinode_structure/BendingProblem.h>
#include <antinode_structure/CeramicBond.h>

#include <catch2/catch.hpp>

#include <cmath>

using namespace antinode;

TEST_CASE ("What a bond hands over builds up from the edges", "[immersed][bond]")
{
    CHECK (bondedShare (0, 1, 0.5) == Approx (1 - 1 / std::cosh (2.0)).epsilon (1e-14));
    CHECK (bondedShare (-0.7, 1, 0.5) == Approx (1 - std::cosh (1.4) / std::cosh (2.0)).epsilon (1e-14));
    CHECK (bondedShare (1, 1, 0.5) == 0);
    CHECK (bondedShare (1 - 1e-3, 1, 1e-3) == Approx (1 - std::exp (-1.0)).epsilon (1e-12)); // cosh 1000 is no number.
    CHECK (bondedShare (0.99, 1, 0) == 1);

    for (const auto length : { 0.05, 0.2, 1.0 })
        for (const auto distance : { 0.0, 0.3, 0.9, 1.0 })
            CHECK (bondedShareOfDisc (distance, 1, length)
                   == Approx (1 - std::cyl_bessel_i (0, distance / length) / std::cyl_bessel_i (0, 1 / length))
                          .margin (1e-6));
}

TEST_CASE ("A square ceramic under equal curvatures has the moment of both its displacements on springs",
           "[immersed][bond]")
{
    // Mean moment over that of a rigid bond, Poisson's ratio 0.35, of a Ritz solution in u and v of degree 4 on 16 x 16
    // cells.
    const auto [sideOverLength, expected] =
        GENERATE (std::pair { 6.0, 0.5968 }, std::pair { 8.0, 0.6881 }, std::pair { 16.0, 0.8376 });
    constexpr double ratio = 0.35;
    BondedPart part;
    part.stiffness << 1, ratio, 0, ratio, 1, 0, 0, 0, (1 - ratio) / 2;
    part.curvaturePerVolt << 1, 1, 0;
    part.half.setConstant (0.5);
    part.lengths.setConstant (1 / sideOverLength);
    part.shearLengths = part.lengths * std::sqrt ((1 - ratio) / 2);
    const auto rule = gaussLegendre (20, 1);
    double mean = 0;

    for (Eigen::Index i = 0; i < rule.nodes.size(); ++i)
        for (Eigen::Index j = 0; j < rule.nodes.size(); ++j)
            mean += rule.weights[i] * rule.weights[j] * part.momentAt ({ rule.nodes[i] - 0.5, rule.nodes[j] - 0.5 }).x()
                    / (1 + ratio);

    CHECK (mean == Approx (expected).epsilon (0.011));

    // Turned, it is the same.
    auto turned = part;
    turned.angle = 0.4;
    const Eigen::Vector2d place (0.31, -0.42);
    const Eigen::Vector2d turnedPlace (std::cos (0.4) * place.x() - std::sin (0.4) * place.y(),
                                       std::sin (0.4) * place.x() + std::cos (0.4) * place.y());
    const auto one = part.momentAt (place), other = turned.momentAt (turnedPlace);
    CHECK (one.x() + one.y() == Approx (other.x() + other.y()).epsilon (1e-12));
}

TEST_CASE ("Where a plate yields, forces build up as Crawley and de Luis have it", "[structure][bond]")
{
    // A plate of the stiffness 1 + r p loses the angle of its length times ln (1 + r) / r, the exact one r times less
    // than its root.
    for (const auto more : { 0.1, 1.0, 5.57 })
        CHECK (yieldingFactor (1 + more) * std::log1p (more) / more
               == Approx (1 / std::sqrt (1 + more)).epsilon (1e-12));

    CHECK (yieldingFactor (1) == 1);
    CHECK (yieldingFactor (1 + 1e-9) == Approx (1).epsilon (1e-6));
}
