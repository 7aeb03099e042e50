#pragma once

#include "FreeDecay.h"

#include <array>
#include <cmath>
#include <complex>

namespace antinode
{
/** A mode while it moves: the recursion of its pole, and of its change by the pole. [worker] Docs/Theory.md, section
    7.6. */
class MovingMode
{
    using Complex = std::complex<double>;

public:
    static constexpr std::size_t places = 4; ///< Of Gauss and Legendre in a sample's interval.
    static constexpr std::array<double, places> gaussPlaces { 0.06943184420297371, 0.33000947820757187,
                                                              0.6699905217924281, 0.9305681557970263 };

    static Complex poleOf (double angularFrequency, double dampingRatio)
    {
        return angularFrequency * Complex { -dampingRatio, std::sqrt (1 - dampingRatio * dampingRatio) };
    }

    MovingMode (double angularFrequency, double dampingRatio, double sampleRate)
        : length (1 / sampleRate), pole (poleOf (angularFrequency, dampingRatio)), turn (std::exp (pole * length)),
          turnByPole (turn * length), ratio (dampingRatio / std::sqrt (1 - dampingRatio * dampingRatio)),
          poleByDamping (angularFrequency * Complex { -dampingRatio, -dampingRatio * ratio })
    {
        for (std::size_t g = 0; g < places; ++g)
        {
            const auto left = length * (1 - gaussPlaces[g]);
            taps[g] = length * gaussWeights[g] * std::exp (pole * left);
            tapsByPole[g] = left * taps[g];
        }
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
                added += taps[g] * force[g];

                if constexpr (withChanges)
                    addedByPole += tapsByPole[g] * force[g];
            }

        if constexpr (withChanges)
            byPole = product (turn, byPole) + product (turnByPole, y) + addedByPole;

        y = product (turn, y) + added;
    }

private:
    static constexpr std::array<double, places> gaussWeights { 0.17392742256872693, 0.32607257743127307,
                                                               0.32607257743127307, 0.17392742256872693 };

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
    std::array<Complex, places> taps, tapsByPole; // a sample makes turn y + sum of taps force of y
    Complex y = 0, byPole = 0;
};
} // namespace antinode
