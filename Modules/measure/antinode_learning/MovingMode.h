#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

namespace antinode
{
/** What forces in a sample's interval add to a mode at its end. */
struct ForceTaps
{
    static constexpr std::size_t places = 4; ///< Of Gauss and Legendre in the interval.
    static constexpr std::array<double, places> gaussPlaces { 0.06943184420297371, 0.33000947820757187,
                                                              0.6699905217924281, 0.9305681557970263 };
    std::array<std::complex<double>, places> taps;   ///< s: sum of tap times force at each place.
    std::array<std::complex<double>, places> byPole; ///< s^2: the taps' derivatives by the pole.
};

/** The taps of the cubic through the forces at the places: exact for it, also where the mode turns several times
    within the interval, where a sum over places has nothing to do with the integral.
    @param pole    1/s
    @param length  s, of the interval
    [any] Docs/Theory.md, section 7.6. */
ForceTaps forceTaps (std::complex<double> pole, double length);

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

/** A mode while it moves: the recursion of its pole, and of its change by the pole. [worker] Docs/Theory.md, section
    7.6. */
class MovingMode
{
    using Complex = std::complex<double>;

public:
    static constexpr auto places = ForceTaps::places;

    static Complex poleOf (double angularFrequency, double dampingRatio)
    {
        return angularFrequency * Complex { -dampingRatio, std::sqrt (1 - dampingRatio * dampingRatio) };
    }

    MovingMode (double angularFrequency, double dampingRatio, double sampleRate)
        : length (1 / sampleRate), pole (poleOf (angularFrequency, dampingRatio)), turn (std::exp (pole * length)),
          turnByPole (turn * length), ratio (dampingRatio / std::sqrt (1 - dampingRatio * dampingRatio)),
          poleByDamping (angularFrequency * Complex { -dampingRatio, -dampingRatio * ratio }),
          ofForces (forceTaps (pole, length))
    {
    }

    // q' = Re y - (a / b) Im y; the ratio depends on the damping ratio alone.
    double velocity() const { return y.real() - ratio * y.imag(); }
    double byFrequency() const { return changed (pole); }
    double byDamping() const { return changed (poleByDamping) - imaginaryByDamping() * y.imag(); }
    double energy() const { return std::norm (y); }

    // How these go on where nothing drives the mode any more.
    FreeDecay velocityAfter() const { return { product ({ 1, ratio }, y), 0 }; }
    FreeDecay byFrequencyAfter() const { return changedAfter (pole); }

    FreeDecay byDampingAfter() const
    {
        auto after = changedAfter (poleByDamping);
        after.constant += product ({ 0, imaginaryByDamping() }, y);
        return after;
    }

    /** To the next sample. @param force  at the places between, nullptr: none */
    template <bool withChanges>
    void advance (const double* force)
    {
        Complex added = 0, addedByPole = 0;

        if (force != nullptr)
            for (std::size_t g = 0; g < places; ++g)
            {
                added += ofForces.taps[g] * force[g];

                if constexpr (withChanges)
                    addedByPole += ofForces.byPole[g] * force[g];
            }

        if constexpr (withChanges)
            byPole = product (turn, byPole) + product (turnByPole, y) + addedByPole;

        y = product (turn, y) + added;
    }

private:
    /** Of finite numbers: without the questions that the operator asks. */
    static Complex product (Complex a, Complex b)
    {
        return { a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real() };
    }

    double imaginaryByDamping() const { return ratio + ratio * ratio * ratio; }

    double changed (Complex ofPole) const
    {
        const auto change = product (byPole, ofPole);
        return change.real() - ratio * change.imag();
    }

    FreeDecay changedAfter (Complex ofPole) const
    {
        const auto seen = product ({ 1, ratio }, ofPole);
        return { product (seen, byPole), product (seen, y) * length };
    }

    double length; // s, of a sample
    Complex pole, turn, turnByPole;
    double ratio;
    Complex poleByDamping;
    ForceTaps ofForces; // a sample makes of y: turn times y and the sum of tap times force
    Complex y = 0, byPole = 0;
};
} // namespace antinode
