#include "RingingBefore.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

namespace antinode
{
namespace
{
constexpr double leastLeft = 1e-3; // of a motion, after the memory
constexpr std::size_t mostSlow = 24;

/** The slowest modes that still ring after a time. */
std::vector<Eigen::Index> slowModes (const Eigen::VectorXd& decays, double memory)
{
    std::vector<Eigen::Index> slow;

    for (Eigen::Index k = 0; k < decays.size(); ++k)
        if (std::exp (-decays[k] * memory) > leastLeft)
            slow.push_back (k);

    std::sort (slow.begin(), slow.end(), [&] (auto one, auto other) { return decays[one] < decays[other]; });
    slow.resize (std::min (slow.size(), mostSlow));
    return slow;
}
} // namespace

RingingBefore::RingingBefore (const ModalModel& modes, double sampleRate, double memory, Eigen::Index samples)
{
    const Eigen::VectorXd decays = decayRates (modes);
    const auto slow = slowModes (decays, memory);
    const auto columns = 2 * static_cast<Eigen::Index> (slow.size());

    if (columns == 0 || columns >= samples)
        return;

    Eigen::MatrixXd rings (samples, columns);

    for (std::size_t j = 0; j < slow.size(); ++j)
    {
        const auto decay = decays[slow[j]], natural = modes.angularFrequencies[slow[j]];
        const auto turning = std::sqrt (std::max (0.0, natural * natural - decay * decay));
        const auto turn = std::exp (std::complex<double> (-decay, turning) / sampleRate);
        std::complex<double> ring = 1;

        for (Eigen::Index n = 0; n < samples; ++n, ring *= turn)
        {
            rings (n, 2 * static_cast<Eigen::Index> (j)) = ring.real();
            rings (n, 2 * static_cast<Eigen::Index> (j) + 1) = ring.imag();
        }
    }

    basis = Eigen::HouseholderQR<Eigen::MatrixXd> (rings).householderQ() * Eigen::MatrixXd::Identity (samples, columns);
}

void RingingBefore::takeOutOf (Eigen::Ref<Eigen::MatrixXd> signals) const
{
    if (basis.size() > 0)
        signals -= basis * (basis.transpose() * signals);
}
} // namespace antinode
