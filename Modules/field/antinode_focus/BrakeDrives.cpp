#include "BrakeDrives.h"

#include "Prediction.h"
#include "Transients.h"

namespace antinode
{
namespace
{
using namespace std::complex_literals;
using Complex = std::complex<double>;

constexpr double greatestCounterShare =
    0.9; // beyond, the brake lasts less than a cycle, so rotating it gives no other brake

std::vector<Oscillation> brakeDrive (int mode, double a, double b, const BrakeWindow& window, Complex phasor)
{
    auto drive = makeOnset (
        { mode, window.start, window.end - releaseDuration(), -window.decay, b, -phasor.imag(), phasor.real() });

    for (const auto& release : makeRelease (drive.front()))
        drive.push_back (release);

    for (auto& oscillation : drive)
        oscillation.freeDecay = a;

    return drive;
}
} // namespace

DriveList brakeDrives (int mode, double a, double b, const BrakeWindow& window)
{
    return { brakeDrive (mode, a, b, window, 1.0), brakeDrive (mode, a, b, window, -1i) };
}

Complex counterShare (Complex pole, const DriveList& drives, Complex force)
{
    return counterShare (pole, drives, force, std::conj (force));
}

Complex counterShare (Complex pole, const DriveList& drives, Complex force, Complex counterForce)
{
    const auto responseTo = [&] (const std::vector<Oscillation>& drive)
    {
        Complex state = 0;

        for (const auto& oscillation : drive)
            state += modalResponse (pole, oscillation, drive.back().end);

        return state;
    };
    const auto first = responseTo (drives[0]), second = 1i * responseTo (drives[1]);
    const auto with = force * (first + second), against = counterForce * (first - second);
    return std::abs (against) < greatestCounterShare * std::abs (with) ? against / with : 0.0;
}
} // namespace antinode
