#pragma once

#include <antinode_identification/IdentifiedModes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace antinode::test
{
/** A structure of which everything is known, to be measured: mass-normalised shapes at the points, and what drives it.
 */
struct KnownStructure
{
    Eigen::MatrixX2d points;       ///< N_p x 2, m.
    Eigen::VectorXd masses;        ///< N_p: kg.
    Eigen::VectorXd frequencies;   ///< N_m: Hz.
    Eigen::VectorXd dampingRatios; ///< N_m
    Eigen::MatrixXd shapes;        ///< N_p x N_m, kg^-1/2.
    Eigen::MatrixXd participation; ///< N_m x N_b
    double delay = 10.7e-6;        ///< s
};

/** A beam of 20 modes, 0.35 to 28 kHz, Q 50 to 200, at 80 points, driven by 5 ceramics. */
inline KnownStructure knownBeam (unsigned seed, Eigen::Index pointCount = 80, Eigen::Index ceramics = 5)
{
    constexpr Eigen::Index modes = 20;
    constexpr double length = 0.15, mass = 0.02;
    std::mt19937_64 random (seed);
    std::uniform_real_distribution<double> uniform (0, 1);
    KnownStructure beam;
    beam.points.setZero (pointCount, 2);
    beam.points.col (0) = Eigen::VectorXd::LinSpaced (pointCount, -length / 2, length / 2);
    beam.masses.setConstant (pointCount, mass / static_cast<double> (pointCount));
    beam.frequencies.resize (modes);
    beam.dampingRatios.resize (modes);
    beam.shapes.resize (pointCount, modes);
    beam.participation.resize (modes, ceramics);

    for (Eigen::Index k = 0; k < modes; ++k)
    {
        const auto n = static_cast<double> (k + 1), wave = (n + 0.5) * std::numbers::pi / length;
        beam.frequencies[k] = 350 * std::pow ((n + 1.393) / 2.393, 2) * (1 + 0.02 * (uniform (random) - 0.5));
        beam.dampingRatios[k] = 1 / (2 * (50 + 150 * uniform (random)));

        for (Eigen::Index p = 0; p < pointCount; ++p)
            beam.shapes (p, k) = std::sqrt (2 / mass) * std::cos (wave * (beam.points (p, 0) + length / 2));

        for (Eigen::Index i = 0; i < ceramics; ++i)
        {
            // The difference of slopes at a ceramic's ends, 9 mm apart.
            const auto centre = length * ((static_cast<double> (i) + 0.37) / static_cast<double> (ceramics));
            beam.participation (k, i) = 2e-4 * wave * std::sqrt (2 / mass)
                                        * (std::sin (wave * (centre - 0.0045)) - std::sin (wave * (centre + 0.0045)));
        }
    }

    return beam;
}

/** The same structure with its lowest modes alone. */
inline KnownStructure lowestModes (KnownStructure structure, Eigen::Index modes)
{
    structure.frequencies = structure.frequencies.head (modes).eval();
    structure.dampingRatios = structure.dampingRatios.head (modes).eval();
    structure.shapes = structure.shapes.leftCols (modes).eval();
    structure.participation = structure.participation.topRows (modes).eval();
    return structure;
}

/** A plate of 124 modes to 30 kHz (others are above), Q 60 to 140, so that half-power bands overlap up to 1.2 times, at
   165 points, driven by 8 ceramics. */
inline KnownStructure knownPlate (unsigned seed, Eigen::Index modes = 124)
{
    constexpr double lengthX = 0.21, lengthY = 0.148, mass = 0.04;
    constexpr Eigen::Index countX = 15, countY = 11, ceramics = 8;
    std::mt19937_64 random (seed);
    std::uniform_real_distribution<double> uniform (0, 1);
    std::vector<std::array<double, 3>> orders;

    for (int m = 1; m < 40; ++m)
        for (int n = 1; n < 40; ++n)
            orders.push_back ({ std::pow (m / lengthX, 2) + std::pow (n / lengthY, 2), double (m), double (n) });

    std::sort (orders.begin(), orders.end());
    const auto scale = 29900 / orders[123][0];
    KnownStructure plate;
    plate.points.resize (countX * countY, 2);
    plate.masses.setConstant (countX * countY, mass / static_cast<double> (countX * countY));

    for (Eigen::Index p = 0; p < countX * countY; ++p)
        plate.points.row (p) << lengthX * (static_cast<double> (p % countX) + 0.5) / countX,
            lengthY * (static_cast<double> (p / countX) + 0.5) / countY;

    Eigen::MatrixX2d centres (ceramics, 2);

    for (Eigen::Index i = 0; i < ceramics; ++i)
        centres.row (i) << lengthX * (0.12 + 0.76 * uniform (random)), lengthY * (0.12 + 0.76 * uniform (random));

    std::vector<std::array<double, 3>> sorted;

    for (Eigen::Index k = 0; k < modes; ++k)
    {
        auto order = orders[static_cast<std::size_t> (k)];
        order[0] *= scale * (1 + 0.004 * (uniform (random) - 0.5));
        sorted.push_back (order);
    }

    std::sort (sorted.begin(), sorted.end());
    plate.frequencies.resize (modes);
    plate.dampingRatios.resize (modes);
    plate.shapes.resize (plate.points.rows(), modes);
    plate.participation.resize (modes, ceramics);

    for (Eigen::Index k = 0; k < modes; ++k)
    {
        const auto& [frequency, m, n] = sorted[static_cast<std::size_t> (k)];
        const auto waveX = m * std::numbers::pi / lengthX, waveY = n * std::numbers::pi / lengthY;
        plate.frequencies[k] = frequency;
        plate.dampingRatios[k] = 1 / (2 * (60 + 80 * uniform (random)));

        for (Eigen::Index p = 0; p < plate.points.rows(); ++p)
            plate.shapes (p, k) =
                2 / std::sqrt (mass) * std::sin (waveX * plate.points (p, 0)) * std::sin (waveY * plate.points (p, 1));

        for (Eigen::Index i = 0; i < ceramics; ++i)
        {
            // kappa times the integral of the Laplacian over a ceramic of 16 mm by 16 mm.
            const auto half = 0.008;
            const auto integral = [half] (double wave, double centre)
            { return (std::cos (wave * (centre - half)) - std::cos (wave * (centre + half))) / wave; };
            plate.participation (k, i) = -0.02 * 2 / std::sqrt (mass) * (waveX * waveX + waveY * waveY)
                                         * integral (waveX, centres (i, 0)) * integral (waveY, centres (i, 1));
        }
    }

    return plate;
}

/** What an ideal vibrometer would see. */
inline FrequencyResponses idealResponses (const KnownStructure& structure, const Eigen::VectorXd& frequencies)
{
    const auto modes = structure.frequencies.size();
    const Eigen::VectorXd omega = 2 * std::numbers::pi * frequencies;
    Eigen::MatrixXcd functions (frequencies.size(), modes);

    for (Eigen::Index k = 0; k < modes; ++k)
        for (Eigen::Index f = 0; f < frequencies.size(); ++f)
        {
            const auto resonance = 2 * std::numbers::pi * structure.frequencies[k];
            const std::complex<double> iOmega (0, omega[f]);
            functions (f, k) =
                iOmega * std::exp (-iOmega * structure.delay)
                / (resonance * resonance + iOmega * iOmega + 2 * structure.dampingRatios[k] * resonance * iOmega);
        }

    FrequencyResponses responses;
    responses.frequencies = frequencies;
    responses.points = structure.points;

    for (Eigen::Index i = 0; i < structure.participation.cols(); ++i)
    {
        responses.references.push_back ({ "C" + std::to_string (i + 1), {} });
        const Eigen::MatrixXd residues = structure.participation.col (i).asDiagonal() * structure.shapes.transpose();
        Eigen::MatrixXcd values (frequencies.size(), structure.points.rows());
        values.real() = functions.real() * residues;
        values.imag() = functions.imag() * residues;
        responses.values.push_back (std::move (values));
    }

    return responses;
}

/** Root of the mean square of all values. */
inline double rootMeanSquare (const FrequencyResponses& responses)
{
    double sum = 0, count = 0;

    for (const auto& values : responses.values)
    {
        sum += values.squaredNorm();
        count += static_cast<double> (values.size());
    }

    return std::sqrt (sum / count);
}

/** Normal numbers in pairs, quickly: the tests draw many millions of them. Box and Muller over splitmix64. The next
    seed gives the same uniform numbers, one later: series of measurements need independentSeed. */
class ComplexNoise
{
public:
    explicit ComplexNoise (std::uint64_t seed) : state (seed * 0x9E3779B97F4A7C15ull + 1) {}

    /** Proper complex, E |x|^2 = 1. */
    std::complex<double> operator()()
    {
        const auto radius = std::sqrt (-std::log (uniform()));
        return std::polar (radius, 2 * std::numbers::pi * uniform());
    }

private:
    double uniform()
    {
        auto z = (state += 0x9E3779B97F4A7C15ull);
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
        return (static_cast<double> ((z ^ (z >> 31)) >> 11) + 0.5) * 0x1p-53;
    }

    std::uint64_t state;
};

/** The seed of one of a series of measurements, whose noise has nothing to do with that of the others. */
inline unsigned independentSeed (unsigned number)
{
    std::seed_seq sequence { number };
    std::array<unsigned, 1> seed {};
    sequence.generate (seed.begin(), seed.end());
    return seed[0];
}

/** Adds proper complex noise whose RMS over all values lies so many dB below that of the responses. @return its RMS */
inline double addNoise (FrequencyResponses& responses, double decibels, unsigned seed)
{
    const auto rms = rootMeanSquare (responses) * std::pow (10, -decibels / 20);
    ComplexNoise noise (seed);

    for (auto& values : responses.values)
        for (auto& value : values.reshaped())
            value += rms * noise();

    return rms;
}

/** Lines every so many Hz. */
inline Eigen::VectorXd lines (double from, double to, double step)
{
    const auto count = static_cast<Eigen::Index> (std::floor ((to - from) / step + 0.5)) + 1;
    return Eigen::VectorXd::LinSpaced (count, from, from + step * static_cast<double> (count - 1));
}
} // namespace antinode::test
