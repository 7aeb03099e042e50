#include "ParameterHelp.h"

#include <map>

namespace antinode
{
namespace
{
const std::map<juce::String, const char*>& effects()
{
    static const std::map<juce::String, const char*> texts {
        { "x", "Where the focus lies, from left to right. Arrow keys on the surface move it too." },
        { "y", "Where the focus lies, from the lower edge upwards. A line has only one place for it." },
        { "width", "How wide the bump is at half of its height. Narrow ones need more modes." },
        { "shape", "The shape of the bump around its centre." },
        { "peak_velocity", "The velocity at the middle of the bump. Voltages grow with it." },
        { "focus_time", "How long after the trigger the bump stands. More time needs less voltage." },
        { "growth",
          "How the drives rise before the focus. Above 0 they rise late, and rest of the surface stays calmer." },
        { "brake", "How fast the surface is brought to rest after the focus, as a multiple of its free decay." },
        { "method", "How the voltages are shared among the ceramics." },
        { "voltage_limit", "No ceramic gets more than this. The lower it is, the less velocity can be reached." },
        { "modes", "How many modes are controlled. More carry a sharper bump and need more voltage." },
        { "notes", "What notes play: the focus at places over the surface, or always at its own." },
        { "note_off", "What a note's end does to the focus that it started." },
        { "retrigger", "What a trigger does while a focus plays." },
        { "focus_on_note", "Whether the focus stands on the note itself; then the latency is the focus time." },
        { "probe_x", "Where the monitor listens, from left to right. The probe can be dragged on the surface." },
        { "probe_y", "Where the monitor listens, from the lower edge upwards." },
        { "monitor_gain", "The level of the probes' velocities on the monitor bus; at 0 dB, 1.0 is 1 m/s." },
        { "output_trim", "The level of all voltages. Below 0 dB the focus is as much weaker." },
        { "arm", "Disarmed, all ceramics stay at 0 V. Key: A" },
        { "bypass", "Bypassed, all ceramics stay at 0 V; the host decides it." },
    };
    return texts;
}
} // namespace

juce::String helpOf (const juce::RangedAudioParameter& parameter)
{
    constexpr int longest = 40;
    const auto found = effects().find (parameter.getParameterID());
    const auto effect = found == effects().end() ? juce::String() : juce::String (found->second) + "\n";
    return effect + "From " + parameter.getText (0, longest) + " to " + parameter.getText (1, longest) + ".";
}
} // namespace antinode
