#include "PlateExamples.h"

#include <antinode_structure/SolvedPlate.h>

using namespace antinode;
using namespace antinode::examples;

namespace
{
/** Each cell cut in two. */
SplineBreaks halved (const SplineBreaks& breaks)
{
    const auto cells = breaks.places.size() - 1;
    auto finer = breaks;
    finer.places.resize (2 * cells + 1);
    finer.multiplicity = Eigen::VectorXi::Ones (2 * cells + 1);

    for (Eigen::Index i = 0; i <= cells; ++i)
    {
        finer.places[2 * i] = breaks.places[i];
        finer.multiplicity[2 * i] = breaks.multiplicity[i];

        if (i < cells)
            finer.places[2 * i + 1] = (breaks.places[i] + breaks.places[i + 1]) / 2;
    }

    return finer;
}

PlateDescription unevenPlate()
{
    auto plate = barePlate ("CSFF", 0.15, 0.1);
    plate.common.ceramics = { plateCeramic (0.02, 0.03, 0.03, 0.02), plateCeramic (0.09, 0.05, 0.02, 0.04) };
    return plate;
}

/** The plate turned by a right angle, counter-clockwise: (x, y) comes to lie at (lengthY - y, x). */
PlateDescription turned (const PlateDescription& plate)
{
    auto result = plate;
    std::swap (result.lengthX, result.lengthY);
    std::swap (result.common.material.youngsModulus1, result.common.material.youngsModulus2);
    result.common.material.poissonRatio12 *=
        plate.common.material.youngsModulus2 / plate.common.material.youngsModulus1;
    result.left = plate.top;
    result.bottom = plate.left;
    result.right = plate.bottom;
    result.top = plate.right;

    for (auto& ceramic : result.common.ceramics)
    {
        const auto x = ceramic.x;
        ceramic.x = plate.lengthY - ceramic.y - ceramic.sizeY;
        ceramic.y = x;
        std::swap (ceramic.sizeX, ceramic.sizeY);
    }

    return result;
}

PlateDescription mirrored (const PlateDescription& plate)
{
    auto result = plate;
    std::swap (result.left, result.right);

    for (auto& ceramic : result.common.ceramics)
        ceramic.x = plate.lengthX - ceramic.x - ceramic.sizeX;

    return result;
}

void checkSame (const ModalModel& a, const ModalModel& b, double frequencyFactor, double participationFactor)
{
    CHECK ((a.angularFrequencies * frequencyFactor - b.angularFrequencies).norm() < 1e-8 * b.angularFrequencies.norm());

    for (Eigen::Index k = 0; k < a.modes(); ++k)
    {
        const Eigen::RowVectorXd p = a.participation.row (k) * participationFactor, q = b.participation.row (k);
        CHECK (std::min ((p - q).norm(), (p + q).norm()) < 1e-5 * b.participation.norm());
    }
}
} // namespace

TEST_CASE ("Frequencies fall on every nested refinement", "[structure][plate]")
{
    const auto plate = unevenPlate();
    const auto layout = makeLayout (plate);

    for (const auto degree : { 3, 4, 5 })
    {
        const PlateResolution resolution { degree, 0.25, 1, 0.3 };
        auto x = divide (layout.linesX, resolution, plate.left, plate.right);
        auto y = divide (layout.linesY, resolution, plate.bottom, plate.top);
        Eigen::VectorXd before = Eigen::VectorXd::Constant (12, 1e300);

        for (int level = 0; level < 3; ++level)
        {
            const auto problem = plateProblem (plate, layout, SplineAxis (x, degree), SplineAxis (y, degree));
            const auto values = solve (problem, 12).values;
            CAPTURE (degree, level);
            CHECK ((values.array() <= before.array() * (1 + 1e-9)).all());
            before = values;
            x = halved (x);
            y = halved (y);
        }
    }
}

TEST_CASE ("A mirrored plate sounds the same", "[structure][plate]")
{
    const auto plate = unevenPlate();
    checkSame (solved (plate, 20), solved (mirrored (plate), 20), 1, 1);
}

TEST_CASE ("A plate turned by a right angle sounds the same, an orthotropic one as well", "[structure][plate]")
{
    auto plate = unevenPlate();
    checkSame (solved (plate, 20), solved (turned (plate), 20), 1, 1);
    plate.common.material.youngsModulus2 = 60e9;
    plate.common.material.shearModulus = 30e9;
    checkSame (solved (plate, 20), solved (turned (plate), 20), 1, 1);
}

TEST_CASE ("A plate a thousand times as large in every dimension is a thousand times as low", "[structure][plate]")
{
    auto plate = unevenPlate(), large = plate;
    const auto factor = 1000.0;

    for (auto* const length : { &large.lengthX, &large.lengthY, &large.common.thickness })
        *length *= factor;

    for (auto& ceramic : large.common.ceramics)
        for (auto* const length : { &ceramic.x, &ceramic.y, &ceramic.sizeX, &ceramic.sizeY, &ceramic.thickness })
            *length *= factor;

    // kappa grows as the length, the integral of the Laplacian as the shapes do: length^-3/2.
    checkSame (solved (plate, 20), solved (large, 20), 1 / factor, std::pow (factor, -0.5));
}

TEST_CASE ("A second solution is the first to the last bit", "[structure][plate]")
{
    const auto plate = unevenPlate();
    const auto a = solved (plate, 20), b = solved (plate, 20);
    CHECK (a.shapes == b.shapes);
    CHECK (a.participation == b.participation);
    CHECK (a.angularFrequencies == b.angularFrequencies);
}

TEST_CASE ("Pairs of one frequency come out with their nodal lines along the axes", "[structure][plate]")
{
    // Modes (1, 2) and (2, 1) of a simply supported square: one has its node at half the height, the other at half the
    // length.
    const auto model = solved (barePlate ("SSSS", 1, 1), 3);
    const auto atHalfLength = shapesAt (model, 0.5, 0.25), atHalfHeight = shapesAt (model, 0.25, 0.5);
    const auto scale = model.shapes.col (1).cwiseAbs().maxCoeff();
    const auto first = std::abs (atHalfLength[1]) < std::abs (atHalfHeight[1]) ? atHalfLength[1] : atHalfHeight[1];
    const auto second = std::abs (atHalfLength[2]) < std::abs (atHalfHeight[2]) ? atHalfLength[2] : atHalfHeight[2];
    CHECK (std::abs (first) < 1e-4 * scale);
    CHECK (std::abs (second) < 1e-4 * scale);
    CHECK (model.angularFrequencies[1] == model.angularFrequencies[2]);
}
