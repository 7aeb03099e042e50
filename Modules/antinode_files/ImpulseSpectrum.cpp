#include "ImpulseSpectrum.h"

#include <unsupported/Eigen/FFT>

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

    const Eigen::VectorXd used = samples.head (count);
    Eigen::FFT<double> transform;
    Eigen::VectorXcd lines;
    transform.fwd (lines, used);
    const auto half = count / 2 + 1;
    const auto recordLength = static_cast<double> (count) * interval;
    return { Eigen::VectorXd::LinSpaced (half, 0, static_cast<double> (half - 1)) / recordLength,
             lines.head (half) * interval, recordLength };
}
} // namespace antinode
