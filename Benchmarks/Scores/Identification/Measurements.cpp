#include "Measurements.h"

#include "Support/DisturbedStructure.h"

namespace antinode::test
{
namespace
{
using Complex = std::complex<double>;

Measured noisy (const KnownStructure& truth, const Eigen::VectorXd& frequencies, double decibels, unsigned seed)
{
    auto responses = idealResponses (truth, frequencies);
    addNoise (responses, decibels, seed);
    return { truth, std::move (responses) };
}

Measured disturbed (const KnownStructure& truth, const Eigen::VectorXd& frequencies, const Disturbance& disturbance,
                    unsigned seed)
{
    return { truth, disturbedResponses (truth, frequencies, disturbance, seed) };
}

/** A plate that hangs softly: below some Hz ten thousand times as much as its modes. */
Measured suspended (unsigned seed)
{
    auto truth = knownPlate (seed, 24);
    truth.frequencies *= 62 / truth.frequencies[0];
    const auto frequencies = lines (1, truth.frequencies.maxCoeff() + 30, 0.5);
    auto measured = noisy (truth, frequencies, 40, seed);
    ComplexNoise noise (seed + 7);
    const auto size = rootMeanSquare (measured.responses);

    for (auto& values : measured.responses.values)
        for (Eigen::Index p = 0; p < values.cols(); ++p)
        {
            const auto strength = 1e4 * size * noise();

            for (Eigen::Index f = 0; f < frequencies.size(); ++f)
                values (f, p) += strength / std::pow (Complex (1, frequencies[f] / 5), 6);
        }

    return measured;
}

/** Every second mode is hardly excited. */
KnownStructure withWeakModes (KnownStructure structure, double strength)
{
    for (Eigen::Index k = 0; k < structure.frequencies.size(); k += 2)
        structure.participation.row (k) *= strength;

    return structure;
}

Measured withFactor (Measured measured, const std::function<Complex (double omega, Eigen::Index point)>& factor)
{
    auto& responses = measured.responses;

    for (auto& values : responses.values)
        for (Eigen::Index p = 0; p < values.cols(); ++p)
            for (Eigen::Index f = 0; f < values.rows(); ++f)
                values (f, p) *= factor (2 * std::numbers::pi * responses.frequencies[f], p);

    return measured;
}

KnownStructure thinPlate (unsigned seed)
{
    auto plate = knownPlate (seed);
    plate.frequencies /= 6;
    return plate;
}

void addNoisy (std::vector<Measurement>& to, unsigned seed, double decibels)
{
    const auto add = [&] (const std::string& name, const auto& make) {
        to.push_back ({ name + "-" + std::to_string (static_cast<int> (decibels)), make });
    };
    add ("beam", [=] { return noisy (knownBeam (seed + 1), lines (200, 29000, 1), decibels, seed + 1); });
    add ("plate", [=] { return noisy (knownPlate (seed + 2), lines (200, 30500, 4), decibels, seed + 2); });
    add ("few-points", [=] { return noisy (knownBeam (seed + 3, 6, 2), lines (200, 12000, 1), decibels, seed + 3); });
    add ("few-lines", [=] { return noisy (knownPlate (seed + 4, 60), lines (200, 16000, 16), decibels, seed + 8); });
    add ("weak-plate",
         [=] {
             return noisy (withWeakModes (knownPlate (seed + 6, 40), 0.05), lines (200, 12000, 8), decibels, seed + 9);
         });
    add ("weak-beam", [=]
         { return noisy (withWeakModes (knownBeam (seed + 8, 10, 2), 0.1), lines (200, 29000, 5), decibels, seed); });
}

void addDisturbed (std::vector<Measurement>& to, unsigned seed)
{
    const auto add = [&] (const std::string& name, double drift, double misfit)
    {
        to.push_back ({ name, [=]
                        {
                            return disturbed (lowestModes (knownBeam (seed + 5, 16, 3), 8), lines (200, 6000, 2),
                                              { drift, misfit }, seed + 4);
                        } });
    };
    add ("drift-50", 50e-6, 0);
    add ("drift-200", 200e-6, 0);
    add ("drift-1000", 1e-3, 0);
    add ("misfit-3", 0, 0.03);
    add ("misfit-10", 0, 0.1);
    to.push_back ({ "plate-drift-200", [=] {
                       return disturbed (knownPlate (seed + 2, 40), lines (200, 13000, 4), { 200e-6, 0.01 }, seed + 4);
                   } });
    to.push_back ({ "suspended", [=] { return suspended (seed + 5); } });
}

void addMistaken (std::vector<Measurement>& to, unsigned seed)
{
    const auto add = [&] (const std::string& name, const auto& factor)
    {
        to.push_back ({ name, [=]
                        {
                            return withFactor (
                                noisy (lowestModes (knownBeam (seed + 7, 8, 2), 5), lines (200, 3500, 2), 45, seed + 3),
                                factor);
                        } });
    };
    add ("displacement", [] (double omega, Eigen::Index) { return 1.0 / Complex (0, omega); });
    add ("delays", [] (double omega, Eigen::Index point)
         { return std::polar (1.0, -15e-6 * omega * static_cast<double> (point)); });
    add ("low-pass", [] (double omega, Eigen::Index) { return 1.0 / Complex (1, omega / 12e3); });
    add ("low-passes", [] (double omega, Eigen::Index point)
         { return 1.0 / Complex (1, omega / (8e3 + 2e3 * static_cast<double> (point))); });
    const auto addMany = [&] (const std::string& name, const auto& factor)
    {
        to.push_back ({ name, [=] {
                           return withFactor (noisy (knownPlate (seed + 2, 40), lines (200, 12000, 4), 45, seed + 2),
                                              factor);
                       } });
    };
    addMany ("plate-low-pass", [] (double omega, Eigen::Index) { return 1.0 / Complex (1, omega / 5e4); });
    addMany ("plate-delays", [] (double omega, Eigen::Index point)
             { return std::polar (1.0, -0.1e-6 * omega * static_cast<double> (point)); });
}
} // namespace

std::vector<Measurement> measurements (unsigned seed)
{
    std::vector<Measurement> result;

    for (const auto decibels : { 40, 20, 10 })
        addNoisy (result, seed, decibels);

    result.push_back (
        { "above-range", [=] { return noisy (knownPlate (seed + 3), lines (200, 8000, 2), 40, seed + 3); } });
    result.push_back (
        { "thin-plate", [=] { return noisy (thinPlate (seed + 2), lines (35, 5080, 1), 40, seed + 2); } });
    addDisturbed (result, seed);
    addMistaken (result, seed);
    return result;
}
} // namespace antinode::test
