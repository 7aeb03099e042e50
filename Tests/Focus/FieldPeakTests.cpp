#include "Support/SineBeam.h"
#include "Support/SinePlate.h"

#include <antinode_focus/EventPeak.h>
#include <antinode_focus/TargetField.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <random>

using namespace antinode;

namespace
{
Eigen::VectorXd randomVelocities (Eigen::Index modes, unsigned seed)
{
    std::mt19937 random (seed);
    Eigen::VectorXd velocities (modes);

    for (auto& velocity : velocities)
        velocity = static_cast<double> (random()) / 4294967296.0 - 0.5;

    return velocities;
}

/** Fields of the sine plate in closed form, without grid or interpolation. */
struct ClosedPlate
{
    test::SinePlate plate;
    int modes = 40;

    std::vector<std::pair<int, int>> halves = plate.halfWaves (modes);

    Eigen::RowVectorXd shapes (double x, double y) const
    {
        Eigen::RowVectorXd row (modes);

        for (Eigen::Index k = 0; k < row.size(); ++k)
        {
            const auto [m, n] = halves[static_cast<std::size_t> (k)];
            row[k] = plate.amplitude() * std::sin (m * std::numbers::pi * x / plate.lengthX)
                     * std::sin (n * std::numbers::pi * y / plate.lengthY);
        }

        return row;
    }

    /** The shapes at even places outside the spots. */
    Eigen::MatrixXd shapesEvenly (int alongX, int alongY, const std::vector<FocalSpot>& spots) const
    {
        std::vector<Eigen::RowVectorXd> rows;

        for (int i = 0; i <= alongX; ++i)
            for (int j = 0; j <= alongY; ++j)
            {
                const auto x = plate.lengthX * i / alongX, y = plate.lengthY * j / alongY;
                bool isOutside = true;

                for (const auto& spot : spots)
                    isOutside = isOutside && std::hypot ((x - spot.x) / spot.radiusX, (y - spot.y) / spot.radiusY) >= 1;

                if (isOutside)
                    rows.push_back (shapes (x, y));
            }

        Eigen::MatrixXd all (static_cast<Eigen::Index> (rows.size()), modes);

        for (std::size_t i = 0; i < rows.size(); ++i)
            all.row (static_cast<Eigen::Index> (i)) = rows[i];

        return all;
    }
};
} // namespace

TEST_CASE ("The largest velocity of a plate lies between its points, as the closed form has it", "[focus][peak]")
{
    // 40 modes have up to 9 half waves: 2/3 mm are 1/66 of a wave, so the even places miss at most 0.3 %.
    const ClosedPlate closed { { .segments = 4, .placesPerSegment = 9 } };
    const auto model = closed.plate.model (closed.modes);
    const auto fine = closed.shapesEvenly (300, 225, {});

    for (unsigned seed = 1; seed <= 8; ++seed)
    {
        CAPTURE (seed);
        const auto velocities = randomVelocities (closed.modes, seed);
        const auto peak = largestVelocity (model, velocities);
        const auto brute = (fine * velocities).cwiseAbs().maxCoeff();
        CHECK (std::abs (peak.velocity) >= brute * (1 - 1e-3));
        CHECK (std::abs (peak.velocity) <= brute * (1 + 3e-3));
        CHECK (peak.velocity == Approx (closed.shapes (peak.x, peak.y).dot (velocities)).epsilon (1e-3));
    }
}

TEST_CASE ("The largest velocity outside focal spots may lie on their boundary", "[focus][peak]")
{
    const ClosedPlate closed { { .segments = 4, .placesPerSegment = 9 } };
    const auto model = closed.plate.model (closed.modes);
    const std::vector<FocalSpot> spots { { 0.06, 0.05, 0.04, 0.03 }, { 0.12, 0.1, 0.05, 0.05 } };
    const auto fine = closed.shapesEvenly (300, 225, spots);
    int onBoundary = 0;

    for (unsigned seed = 1; seed <= 12; ++seed)
    {
        CAPTURE (seed);
        const auto velocities = randomVelocities (closed.modes, seed);
        const auto peak = largestVelocity (model, velocities, spots);
        const auto brute = (fine * velocities).cwiseAbs().maxCoeff();
        CHECK (std::abs (peak.velocity) >= brute * (1 - 1e-3));

        // On a slope at the boundary the even places miss up to 2/3 mm of a wave of 44 mm.
        CHECK (std::abs (peak.velocity) <= brute * 1.06);

        for (const auto& spot : spots)
        {
            const auto away = std::hypot ((peak.x - spot.x) / spot.radiusX, (peak.y - spot.y) / spot.radiusY);
            CHECK (away > 1 - 1e-6);
            onBoundary += away < 1 + 1e-6 ? 1 : 0;
        }
    }

    CHECK (onBoundary > 0);
    CHECK (largestVelocity (model, randomVelocities (closed.modes, 1), { { 0.1, 0.1, 1, 1 } }).velocity == 0);
}

TEST_CASE ("The largest velocity of a beam is that of its closed form", "[focus][peak]")
{
    const auto model = test::sineBeam (60, 0);
    const auto scale = model.shapes.cwiseAbs().maxCoeff();

    for (unsigned seed = 1; seed <= 8; ++seed)
    {
        CAPTURE (seed);
        const auto velocities = randomVelocities (60, seed);
        double brute = 0;

        for (int i = 0; i <= 40000; ++i)
        {
            double sum = 0;

            for (int k = 0; k < 60; ++k)
                sum += velocities[k] * scale * std::sin ((k + 1) * std::numbers::pi * i / 40000);

            brute = std::max (brute, std::abs (sum));
        }

        CHECK (std::abs (largestVelocity (model, velocities).velocity) == Approx (brute).epsilon (1e-3));
    }
}

TEST_CASE ("The peak of several targets is not that of one", "[focus][peak]")
{
    const auto surface = test::SinePlate().surface();
    const Target one { TargetShape::gaussian, 0.0771, 0.0613, 0.03, 0.04, 1 };
    auto other = one;
    other.x += 0.012;

    // Two equal gaussians nearer than 0.85 of their width have one top, half-way between them.
    const auto half = std::exp (-4 * std::numbers::ln2 * 0.006 * 0.006 / (0.03 * 0.03));
    const auto peak = largestWanted (surface, { one, other }, {});
    CHECK (peak.velocity == Approx (2 * 0.04 * half).epsilon (1e-4));
    CHECK (peak.x == Approx (0.0831).margin (2e-4));
    CHECK (largestWanted (surface, { one }, {}).velocity == Approx (0.04).epsilon (1e-9));
}

TEST_CASE ("The largest velocity of an event lies between points and samples, as the closed form has it",
           "[focus][peak]")
{
    const ClosedPlate closed { { .segments = 4, .placesPerSegment = 9 }, 24 };
    const auto model = closed.plate.model (closed.modes);
    constexpr double rate = 22050; // Below 0.75 of its Nyquist frequency lie all 24 modes.
    REQUIRE (model.frequencyHz (closed.modes - 1) < 0.375 * rate);
    const std::vector<FocalSpot> spots { { 0.08, 0.07, 0.02, 0.02 } };
    const auto fine = closed.shapesEvenly (100, 75, spots);

    for (unsigned seed = 1; seed <= 3; ++seed)
    {
        CAPTURE (seed);
        const auto amplitudes = randomVelocities (closed.modes, seed);
        const auto at = [&] (double time) -> Eigen::VectorXd
        {
            const auto envelope = std::exp (-std::pow ((time - 0.004) / 0.0015, 2));
            return (envelope * amplitudes.array() * (model.angularFrequencies.array() * time).cos()).matrix();
        };
        Eigen::MatrixXd samples (closed.modes, 180);

        for (Eigen::Index n = 0; n < samples.cols(); ++n)
            samples.col (n) = at (static_cast<double> (n) / rate);

        double brute = 0;

        for (double time = 0.002; time < 0.006; time += 2e-6)
            brute = std::max (brute, (fine * at (time)).cwiseAbs().maxCoeff());

        const auto peak = largestInEvent (model, { samples, rate }, spots, 0, samples.cols() - 1);
        CHECK (std::abs (peak.velocity) >= brute * (1 - 1e-3));
        CHECK (std::abs (peak.velocity) <= brute * 1.06); // Places of 2 mm on a wave of some 40 mm.
        CHECK (peak.velocity == Approx (closed.shapes (peak.x, peak.y).dot (at (peak.time))).epsilon (1e-3));
        CHECK (std::hypot (peak.x - 0.08, peak.y - 0.07) > 0.02 * (1 - 1e-6));
    }
}

TEST_CASE ("The largest value of a tone lies between its samples", "[focus][peak]")
{
    // Three samples per period: they miss up to half of the amplitude.
    Eigen::RowVectorXd tone (200);

    for (Eigen::Index n = 0; n < tone.size(); ++n)
    {
        const auto t = static_cast<double> (n) - 100.3;
        tone[n] = -std::exp (-t * t / 400) * std::cos (2 * std::numbers::pi * t / 3.1);
    }

    const auto peak = largestInTime (tone);
    CHECK (peak.position == Approx (100.3).margin (1e-2));
    CHECK (peak.value == Approx (-1).epsilon (1e-4));
}

TEST_CASE ("The width of a reached peak is that of a field known in closed form", "[focus][peak]")
{
    // One mode of the plate: half of a sine's peak is 1/3 of its half wave to both sides.
    const ClosedPlate closed { { .segments = 4, .placesPerSegment = 9 }, 12 };
    const auto model = closed.plate.model (closed.modes);
    const auto halves = closed.plate.halfWaves (closed.modes);

    for (Eigen::Index k = 0; k < 12; ++k)
    {
        const auto [m, n] = halves[static_cast<std::size_t> (k)];
        const Eigen::VectorXd velocities = -Eigen::VectorXd::Unit (12, k);
        const auto x = 0.2 / (2 * m), y = 0.15 / (2 * n);
        const auto peak = peakOfTarget (model, velocities, { TargetShape::sinc, x * 1.2, y * 0.9, y, 1, -1 });
        CHECK (peak.x == Approx (x).epsilon (0.01));
        CHECK (peak.y == Approx (y).epsilon (0.01));
        CHECK (peak.velocity == Approx (-closed.plate.amplitude()).epsilon (1e-3));
        CHECK (widthAtHalf (model, velocities, peak, false).value() == Approx (0.2 / m * 2 / 3).epsilon (2e-3));
        CHECK (widthAtHalf (model, velocities, peak, true).value() == Approx (0.15 / n * 2 / 3).epsilon (2e-3));
    }
}
