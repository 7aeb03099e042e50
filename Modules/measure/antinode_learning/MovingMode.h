#pragma once

#include "ForceTaps.h"
#include "FreeDecay.h"

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
