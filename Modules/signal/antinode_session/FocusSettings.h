#pragma once

#include <antinode_focus/FocusDescription.h>
#include <antinode_model/Surface.h>
#include <antinode_structure/DeviceDescription.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace antinode
{
/** The layout of the notes. */
enum class NoteLayout
{
    spread, ///< Middle C the focus at its own place, the others at places spread over the surface.
    spot    ///< Every note the focus at its own place.
};

/** The parameters of a host for the focus: numbers as a host keeps them, in the units of their names.
    Docs/Manual/parameters.md. */
struct PlaySettings
{
    float xPercent = 50, yPercent = 50; ///< Of the surface's extent, from its left and its lower edge.
    float widthMillimetres = 25;
    TargetShape shape = TargetShape::sinc;
    float peakVelocityMillimetresPerSecond = 40;
    float focusTimeMilliseconds = 25;
    float growth = -1; ///< Below 0: as the focus says, or chosen.
    float brake = 0;   ///< 1 or below: as the focus says, or none.
    AllocationMethod method = AllocationMethod::exact;
    const RetiredMethod* retired = nullptr; ///< As AllocationChoice::retired; the method is then what is used instead.
    float voltageLimitVolts = 0;            ///< 0: as the focus says, or the device's.
    int modeCount = 0;                      ///< 0: as the focus says, or chosen.
    float probeXPercent = 50, probeYPercent = 50;
    NoteLayout noteLayout = NoteLayout::spread;
    bool focusOnNote = false; ///< Of which the host knows the latency; what plays has it in its controls.

    bool operator== (const PlaySettings&) const = default;
};

/** The parameters of a loaded focus. [any] */
PlaySettings settingsFromFocus (const FocusDescription&, const Surface&, const PlaySettings& present);

/** A focus by another method: what that one does not take is left out.
    @param retired  as PlaySettings has it [any] */
FocusDescription withMethod (FocusDescription, AllocationMethod, const RetiredMethod* retired = nullptr);

/** A loaded focus as the parameters have changed it. What a parameter says as the focus does is taken from the focus,
   to the bit: so the same focus gives the same voltages in a host and on the command line.
    @param document  what was loaded, with at least one target
    [any] */
FocusDescription withSettings (const FocusDescription& document, const PlaySettings&, const Surface&);

/** Samples from a trigger to its focus where foci are delayed onto notes, else 0. [any] */
std::int64_t estimateLatency (const FocusDescription& document, const PlaySettings&, double sampleRate);

/** When the last voltage of a trigger ends as far as it is known without a design: after the last focus and the time
   that its brake is given, s. [any] */
double estimateEnd (const FocusDescription& document, const PlaySettings&);

/** A place from percents of the surface's extent. @return  x, y in m [any] */
std::pair<double, double> placeFromPercent (const Surface&, double xPercent, double yPercent);

/** The same, back. [any] */
std::pair<double, double> percentFromPlace (const Surface&, double x, double y);

/** The positions of the monitor probes: the probe of the parameters, then the second probe of the focus, or else its
   first target. m [any] */
std::vector<std::pair<double, double>> probePlaces (const FocusDescription& document, const PlaySettings&,
                                                    const Surface&);
} // namespace antinode
