#include "PerformedDesign.h"

#include <antinode_base/InputError.h>
#include <antinode_base/NumberText.h>
#include <antinode_focus/FocusMoments.h>
#include <antinode_focus/Projection.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
constexpr double longest = 60;     // s, of a focus in a file
constexpr double spotWidth = 0.02; // m: about a fingertip

/** When and where the wanted motion is fastest. */
struct FastestMotion
{
    Eigen::Index sample = 0;
    std::size_t track = 0;
    double velocity = 0; // m/s
};

FastestMotion fastestMotion (const TrackDesign& design)
{
    FastestMotion fastest;
    const auto& wanted = design.wanted;
    const auto tracks = static_cast<Eigen::Index> (design.description.tracks.size());

    for (Eigen::Index p = 0; p < tracks; ++p)
        for (Eigen::Index n = 1; n + 1 < wanted.rows(); ++n)
        {
            const auto velocity = (wanted (n + 1, p) - wanted (n - 1, p)) / 2 * design.voltages.playback.sampleRate;

            if (std::abs (velocity) > std::abs (fastest.velocity))
                fastest = { n, static_cast<std::size_t> (p), velocity };
        }

    return fastest;
}

FocusDescription describedFocus (const PerformedWaveforms& performed)
{
    const auto& design = performed.design;
    const auto& waveforms = design.description;
    const auto fastest = fastestMotion (design);
    const auto time = static_cast<double> (fastest.sample) / design.voltages.playback.sampleRate;
    const auto at = placeAt (waveforms.tracks[fastest.track].point, time);
    FocusDescription focus;
    focus.name = waveforms.name;
    focus.focusTime = time - design.voltages.firstTime;
    focus.targets.push_back (
        { TargetShape::bump, at.x, at.y, spotWidth, std::abs (fastest.velocity), fastest.velocity < 0 ? -1 : 1 });
    focus.allocation.method = AllocationMethod::freeWaveform;

    for (const auto& point : touchedPoints (waveforms))
    {
        focus.probes.emplace_back (point.x, point.y);

        if (point.finger)
        {
            focus.fingers.push_back (*point.finger);
            focus.fingers.back().isKnown = false;
        }
    }

    if (focus.focusTime > longest)
        throw InputError ("waveforms", "have their fastest motion " + inWords (focus.focusTime)
                                           + " s after the first sample; allowed in a design: " + inWords (longest)
                                           + " s");

    return focus;
}

/** The modes of the band; the lowest at least. */
std::vector<int> modesOfBand (const ModalModel& model, const TrackBand& band)
{
    std::vector<int> modes { 0 };

    for (int k = 1; k < static_cast<int> (model.modes()) && model.frequencyHz (k) <= band.upper; ++k)
        modes.push_back (k);

    return modes;
}

void addMoments (FocusDesign& design, const ModalModel& model)
{
    design.moments = focusMoments (model, design.description, design.playback);
    auto& moment = design.moments.front();
    auto represented = restrictToModes (model, moment.target, design.controlledModes);
    moment.wanted = std::move (represented.wanted);
    moment.truncatedField = std::move (represented.truncated);
    moment.captured = represented.captured;
    design.target = moment.target;
    design.truncatedField = moment.truncatedField;
    design.captured = moment.captured;
    design.residue = std::sqrt (std::max (0.0, 1 - moment.captured * moment.captured));
}
} // namespace

FocusDesign performedDesign (const PerformedWaveforms& performed, const ModalModel& own)
{
    const auto& made = performed.design;
    FocusDesign design;
    design.description = describedFocus (performed);
    design.playback = made.voltages.playback;
    design.controlledModes = modesOfBand (own, made.description.band);
    design.growth.assign (design.controlledModes.size(), 0.0);
    design.cycles.assign (design.controlledModes.size(), 0);
    addMoments (design, own);
    design.program.focusTime = design.description.focusTime;
    design.program.voltageLimits = voltageLimits (own);
    design.program.allocation.resize (own.actuators(), 0);
    design.program.samples = made.voltages;
    design.program.samples->firstTime = 0;
    design.certificate.peakVoltage = made.peaks.maxCoeff();
    design.certificate.peakRatio = made.peaks.cwiseQuotient (design.program.voltageLimits).maxCoeff();
    design.reachablePeakVelocity = design.description.targets.front().peakVelocity;
    design.choices.push_back ("Voltages of waveforms at fingers, from their first sample on. The target represents the "
                              "fastest wanted motion of a track; scores against it do not apply to the waveforms.");
    design.warnings = made.warnings;
    return design;
}
} // namespace antinode
