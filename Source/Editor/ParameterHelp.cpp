#include "ParameterHelp.h"

#include <map>

namespace antinode
{
namespace
{
const std::map<juce::String, const char*>& effects()
{
    static const std::map<juce::String, const char*> texts {
        { "x", "Position of the focus from left to right. Arrow keys on the surface also move it." },
        { "y", "Position of the focus from the lower edge upwards. Has no effect on a line." },
        { "width", "Full width of the focus at half maximum. Narrow foci need more modes." },
        { "shape", "Shape of the focus around its centre." },
        { "peak_velocity", "Velocity at the centre of the focus. Voltages are proportional to it." },
        { "focus_time", "Time from the trigger to the focus. More time needs less voltage." },
        { "growth",
          "Growth of the drives before the focus. Large values start late and keep the rest of the surface calmer." },
        { "brake", "Decay after the focus as a multiple of the free decay." },
        { "method", "Method that allocates the voltages to the ceramics." },
        { "voltage_limit", "Largest voltage of every ceramic. A lower limit allows less velocity." },
        { "modes", "Number of controlled modes. More modes make a sharper focus and need more voltage." },
        { "notes", "What notes play: the focus at positions spread over the surface, or always at its own position." },
        { "note_off", "Effect of a note-off on the focus that the note started." },
        { "retrigger", "Effect of a trigger while its focus still plays." },
        { "focus_on_note", "Whether the focus falls on the note; the latency is then the focus time." },
        { "probe_x", "Position of the probe from left to right. The probe can be dragged on the surface." },
        { "probe_y", "Position of the probe from the lower edge upwards." },
        { "monitor_gain", "Gain of the probe velocities on the monitor bus; at 0 dB, 1.0 is 1 m/s." },
        { "output_trim", "Gain of all voltages. Below 0 dB the velocity decreases in proportion." },
        { "arm", "If disarmed, all ceramics stay at 0 V. Key: A" },
        { "bypass", "If bypassed by the host, all ceramics stay at 0 V." },
        { "finger_x", "Place of the finger from left to right. It can be dragged on the surface." },
        { "finger_y", "Place of the finger from the lower edge upwards. Has no effect on a line." },
        { "finger_state", "Absent: nowhere. Silent: it rests and is to feel nothing. Plays: it feels its input." },
        { "finger_level", "Displacement of the surface under the finger where its input is 1.0." },
        { "finger_load", "What the finger is to the surface; the filters then know it." },
        { "latency", "From an input to the motion, reported to the host. 5 ms needs most volts." },
        { "gain", "Factor of all levels." },
    };
    return texts;
}
} // namespace

juce::String helpText (const juce::RangedAudioParameter& parameter)
{
    constexpr int longest = 40;
    const auto identifier = parameter.getParameterID();
    const auto isOfFinger = identifier.startsWith ("finger"); // finger3_x
    const auto found =
        effects().find (isOfFinger ? "finger" + identifier.fromFirstOccurrenceOf ("_", true, false) : identifier);
    const auto effect = found == effects().end() ? juce::String() : juce::String (found->second) + "\n";
    return effect + "From " + parameter.getText (0, longest) + " to " + parameter.getText (1, longest) + ".";
}
} // namespace antinode
