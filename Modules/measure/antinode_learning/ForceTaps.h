#pragma once

#include <array>
#include <complex>
#include <cstddef>

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
} // namespace antinode
