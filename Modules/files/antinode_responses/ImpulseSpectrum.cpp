#include "ImpulseSpectrum.h"

#include <antinode_numerics/Fourier.h>

namespace antinode
{
namespace
{
bool isQuick (Eigen::Index count)
{
    for (const Eigen::Index factor : { 2, 3, 5 })
        while (count % factor == 0)
            count /= factor;

    return count == 1;
}
} // namespace

ImpulseSpectrum impulseSpectrum (const Eigen::VectorXd& samples, double interval)
{
    auto count = samples.size();

    while (! isQuick (count)) // A large prime factor would take a time that grows as its square.
        --count;

    // A constant counts at 0 Hz alone: elsewhere not even its rounding is left.
    Eigen::VectorXcd lines = forwardFourier (Eigen::VectorXd (samples.head (count).array() - samples[0]));
    lines[0] += static_cast<double> (count) * samples[0];
    const auto recordLength = static_cast<double> (count) * interval;
    return { Eigen::VectorXd::LinSpaced (lines.size(), 0, static_cast<double> (lines.size() - 1)) / recordLength,
             lines * interval, recordLength };
}
} // namespace antinode
