#include "ShearModulus.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace antinode
{
namespace
{
std::complex<double> lossy (double shearModulus, double lossFactor)
{
    return { shearModulus, shearModulus * lossFactor };
}

std::complex<double> fromTable (const std::vector<ShearAtFrequency>& table, double frequency)
{
    const auto above =
        std::upper_bound (table.begin(), table.end(), frequency,
                          [] (double value, const ShearAtFrequency& row) { return value < row.frequency; });

    if (above == table.begin())
        return lossy (table.front().shearModulus, table.front().lossFactor);

    if (above == table.end())
        return lossy (table.back().shearModulus, table.back().lossFactor);

    const auto& below = *std::prev (above);
    const auto share = std::log (frequency / below.frequency) / std::log (above->frequency / below.frequency);
    return lossy (below.shearModulus * std::pow (above->shearModulus / below.shearModulus, share),
                  std::lerp (below.lossFactor, above->lossFactor, share));
}
} // namespace

std::complex<double> shearModulusAt (const ViscoelasticMaterial& material, double angularFrequency)
{
    if (! material.table.empty())
        return fromTable (material.table, angularFrequency / (2 * std::numbers::pi));

    std::complex<double> modulus = material.slowShearModulus;

    for (const auto& term : material.relaxation)
    {
        const std::complex<double> phase (0, angularFrequency * term.time);
        modulus += term.shearModulus * phase / (1.0 + phase);
    }

    return modulus;
}
} // namespace antinode
