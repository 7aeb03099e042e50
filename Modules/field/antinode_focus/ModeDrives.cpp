#include "ModeDrives.h"

#include "DriveAllocation.h"
#include "Prediction.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace antinode
{
namespace
{
using namespace std::complex_literals;
using Complex = std::complex<double>;

constexpr double envelopeFolds = 4;           // e-folds of growth that the chosen envelope spends before the focus
constexpr double greatestEnvelopeFolds = 600; // beyond, the start of a drive would underflow
constexpr double chosenGreatestFolds = 40;    // beyond, an earlier start adds less than 1e-17
constexpr double releaseDecay = 1e-6;

double driveDuration (double dampedFrequency, int cycles)
{
    return (0.5 + 2 * cycles) * std::numbers::pi / dampedFrequency;
}

Oscillation oscillationFrom (int mode, double start, double end, Complex exponent, Complex phasor)
{
    return { mode, start, end, exponent.real(), exponent.imag(), -phasor.imag(), phasor.real() };
}

std::string modeName (const ModalModel& model, int mode)
{
    return "mode " + std::to_string (mode + 1) + " (" + std::to_string (std::lround (model.frequencyHz (mode)))
           + " Hz)";
}

template <typename Value>
Value valueFor (const std::vector<Value>& list, std::size_t index)
{
    return list.size() == 1 ? list.front() : list[index];
}

void checkLength (std::size_t length, std::size_t modes, const char* field)
{
    if (length > 1 && length != modes)
        throw InputError (std::string ("focus: ") + field,
                          "has " + std::to_string (length) + " values, but " + std::to_string (modes)
                              + " modes are controlled; allowed: one value, or one per mode");
}

int cyclesThatFit (double dampedFrequency, double time)
{
    return static_cast<int> (std::floor ((dampedFrequency * time / std::numbers::pi - 0.5) / 2 + 1e-9));
}

/** As many cycles as fit and still count. */
int chooseCycles (const ModalModel& model, const DrivenMode& driven, double time)
{
    const auto b = driven.dampedFrequency, rate = driven.growth * driven.decayRate;
    const auto maximum = cyclesThatFit (b, time);

    if (maximum < 0)
        throw InputError ("focus: focus time", "leaves " + inWords (time * 1000) + " ms to drive "
                                                   + modeName (model, driven.mode)
                                                   + ", which needs a quarter period; allowed: at least "
                                                   + inWords (driveDuration (b, 0) * 1000) + " ms");

    if (rate * time <= chosenGreatestFolds)
        return maximum;

    return std::clamp (cyclesThatFit (b, chosenGreatestFolds / rate), 0, maximum);
}

/** An onset takes a little of the motion: the drive is made that much larger. */
void normalise (ModeDrive& drive, Complex pole, double focusTime)
{
    Complex state = 0;

    for (const auto& oscillation : drive.oscillations)
        state += modalResponse (pole, oscillation, focusTime);

    const auto velocity = state.real() + pole.real() / pole.imag() * state.imag();

    for (auto& oscillation : drive.oscillations)
    {
        oscillation.inPhase /= velocity;
        oscillation.quadrature /= velocity;
    }
}

void checkCycles (const ModalModel& model, const DrivenMode& driven, double time)
{
    const auto rate = driven.growth * driven.decayRate;
    const auto maximum = cyclesThatFit (driven.dampedFrequency,
                                        rate * time <= greatestEnvelopeFolds ? time : greatestEnvelopeFolds / rate);

    if (driven.cycles > maximum)
        throw InputError ("focus: cycles", "is " + std::to_string (driven.cycles) + " for "
                                               + modeName (model, driven.mode) + "; allowed: 0 to "
                                               + std::to_string (std::max (maximum, 0))
                                               + " with this focus time and growth");
}
} // namespace

double releaseRate()
{
    return 20000; // 50 us: short against what a finger feels, long against a sample
}

double releaseDuration()
{
    return -std::log (releaseDecay) / releaseRate();
}

std::vector<Oscillation> makeRelease (const Oscillation& oscillation)
{
    const auto phasor =
        oscillation.phasor() * std::exp (oscillation.exponent() * (oscillation.end - oscillation.start));
    const auto share = oscillation.growth / releaseRate();
    const auto part = [&] (double folds, double weight)
    {
        return oscillationFrom (oscillation.mode, oscillation.end, oscillation.end + releaseDuration(),
                                { -folds * releaseRate(), oscillation.angularFrequency }, weight * phasor);
    };
    return { part (1, 2 + share), part (2, -1 - share) };
}

std::vector<Oscillation> makeOnset (const Oscillation& oscillation)
{
    const auto part = [&] (int folds, double weight)
    {
        auto shaping = oscillation;
        shaping.end = std::min (oscillation.end, oscillation.start + releaseDuration());
        shaping.growth = oscillation.growth - folds * releaseRate();
        shaping.inPhase *= weight;
        shaping.quadrature *= weight;
        return shaping;
    };
    return { oscillation, part (1, -2), part (2, 1) };
}

std::vector<Oscillation> playedDrive (const std::vector<Oscillation>& untilFocus, DriveStart start)
{
    std::vector<Oscillation> played;

    for (const auto& oscillation : untilFocus)
        if (start == DriveStart::jump)
            played.push_back (oscillation);
        else
            for (const auto& part : makeOnset (oscillation))
                played.push_back (part);

    const auto rising = played;

    for (const auto& oscillation : rising)
        if (oscillation.end == untilFocus.front().end)
            for (const auto& release : makeRelease (oscillation))
                played.push_back (release);

    return played;
}

ModeDrive driveMode (const DrivenMode& driven, DriveKind kind, double focusTime, DriveStart start)
{
    const auto [mode, a, b, growth, cycles] = driven;
    const auto duration = driveDuration (b, cycles);
    const auto begin = focusTime - duration;
    const Complex exponent (growth * a, b);
    const auto squaredExponent = std::norm (exponent);                     // D of the paper
    const auto constantShare = (a * a + b * b) / squaredExponent;          // rho
    const auto stiffness = (growth + 1) * a * ((growth + 1) * a + 2i * b); // P (p)
    const auto grown = std::exp (growth * a * duration);
    ModeDrive drive { mode, growth, cycles, {} };

    const auto amplitude =
        kind == DriveKind::paper ? 1 / grown : 1 / (grown - constantShare * std::exp (-a * duration));
    drive.oscillations.push_back (
        oscillationFrom (mode, begin, focusTime, exponent, -1i * amplitude * stiffness / exponent));

    // Without the constant the mode's own decay e^{-at} adds to the envelope; with it the paper's (26) is exact.
    if (kind == DriveKind::paper)
        drive.oscillations.push_back (oscillationFrom (mode, begin, focusTime, 0.0, amplitude * b * constantShare));

    drive.oscillations = playedDrive (drive.oscillations, start);

    if (start == DriveStart::smooth)
        normalise (drive, { -a, b }, focusTime);

    return drive;
}

DriveStart driveStart (const ModalModel& model)
{
    return hasSlewLimits (model) ? DriveStart::smooth : DriveStart::jump;
}

std::vector<ModeDrive> driveModes (const ModalModel& model, const std::vector<int>& modes, double focusTime,
                                   const TransientChoice& choice)
{
    checkLength (choice.growth.size(), modes.size(), "growth");
    checkLength (choice.cycles.size(), modes.size(), "cycles");
    const auto time = std::min (focusTime, choice.maximumDuration.value_or (focusTime));
    const auto decay = decayRates (model);
    const auto frequency = dampedFrequencies (model);
    std::vector<ModeDrive> drives;

    for (std::size_t i = 0; i < modes.size(); ++i)
    {
        DrivenMode driven { modes[i], decay[modes[i]], frequency[modes[i]], 0, 0 };
        driven.growth = choice.growth.empty() ? envelopeFolds / (time * driven.decayRate) : valueFor (choice.growth, i);
        driven.cycles = choice.cycles.empty() ? chooseCycles (model, driven, time) : valueFor (choice.cycles, i);
        checkCycles (model, driven, time);
        drives.push_back (driveMode (driven, choice.drive, focusTime, driveStart (model)));
    }

    return drives;
}

namespace
{
/** The drives of driveModes with other growths than it would choose. */
std::vector<ModeDrive> steeperDrives (const ModalModel& model, const std::vector<int>& modes, double focusTime,
                                      const TransientChoice& choice)
{
    constexpr auto times = 3.0;
    auto steeper = choice;

    for (const auto& drive : driveModes (model, modes, focusTime, choice))
        steeper.growth.push_back (times * drive.growth);

    return driveModes (model, modes, focusTime, steeper);
}

/** An offset-free drive that is a quarter period later; empty if it would begin before the trigger. */
std::vector<Oscillation> shifted (const ModeDrive& drive, DriveStart start)
{
    auto oscillation = drive.oscillations.front();
    const auto quarter = 0.5 * std::numbers::pi / oscillation.angularFrequency;
    oscillation.start += drive.cycles > 0 ? quarter : -quarter;

    if (oscillation.start < 0)
        return {};

    return playedDrive ({ oscillation }, start);
}

void append (DriveList& list, const std::vector<ModeDrive>& drives)
{
    for (const auto& drive : drives)
        list.push_back (drive.oscillations);
}

void appendShifted (DriveList& list, const std::vector<ModeDrive>& drives, DriveStart start)
{
    for (const auto& drive : drives)
        if (auto other = shifted (drive, start); ! other.empty())
            list.push_back (std::move (other));
}
} // namespace

DriveList fasterDrives (const ModalModel& model, const std::vector<int>& modes, double focusTime,
                        const TransientChoice& choice)
{
    DriveList drives;

    if (choice.growth.empty())
        append (drives, steeperDrives (model, modes, focusTime, choice));

    return drives;
}

DriveList furtherDrives (const ModalModel& model, const std::vector<int>& modes, double focusTime,
                         const TransientChoice& choice)
{
    auto drives = fasterDrives (model, modes, focusTime, choice);
    const auto start = driveStart (model);
    appendShifted (drives, driveModes (model, modes, focusTime, choice), start);

    if (choice.growth.empty())
        appendShifted (drives, steeperDrives (model, modes, focusTime, choice), start);

    return drives;
}
} // namespace antinode
