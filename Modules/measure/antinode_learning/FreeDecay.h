#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <complex>
#include <vector>

namespace antinode
{
/** What a mode that nothing drives does from sample to sample: Re ((constant + slope n) turn^n). The change of such a
    motion by the pole has the slope. */
struct FreeDecay
{
    std::complex<double> constant = 0, slope = 0;

    /** As weights of the four columns that DecayPart has for the mode. [any] */
    Eigen::Vector4d parts() const { return { constant.real(), constant.imag(), slope.real(), slope.imag() }; }
};

/** The inner products of free decays of two modes over their first samples, in closed form: with the parts a and b of
    one decay of each, a' M b.
    @param one, other  the modes' logarithms of what a sample does to them: pole times its length
    [any] Docs/Theory.md, section 7.6. */
Eigen::Matrix4d decayProducts (std::complex<double> one, std::complex<double> other, Eigen::Index samples);

/** Some samples of free decays: Re turn^n, -Im turn^n and n times these of each mode that can still be heard. */
struct DecayPart
{
    Eigen::Index first = 0;            ///< Sample.
    Eigen::MatrixXd basis;             ///< Samples x 4 for each of these modes.
    std::vector<Eigen::Index> columns; ///< Of all modes' 4 columns each: which these are.
};

/** A part of the samples of all modes' free decays. @param logarithms  of the modes: as decayProducts [worker] */
DecayPart decayPart (const Eigen::VectorXcd& logarithms, Eigen::Index first, Eigen::Index samples);

/** The samples of free decays of modes, part by part.
    @param use  called for each part of the first samples, in order, in which a mode can still be heard
    [worker] */
template <typename Use>
void forEachDecayPart (const Eigen::VectorXcd& logarithms, Eigen::Index samples, const Use& use)
{
    constexpr Eigen::Index length = 512;

    for (Eigen::Index first = 0; first < samples; first += length)
        if (const auto part = decayPart (logarithms, first, std::min (length, samples - first)); ! part.columns.empty())
            use (part);
}
} // namespace antinode
