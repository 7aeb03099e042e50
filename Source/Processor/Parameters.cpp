#include "Parameters.h"

#include "GroupBuilder.h"
#include "ParameterTexts.h"

#include <antinode_documents/FocusWords.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

namespace antinode
{
namespace
{
constexpr double silentDecibels = -60;
constexpr float silentText = -60 + 1e-3F; // below which it is called silent

ParameterRange logarithmic (double minimum, double maximum)
{
    return { minimum, maximum, true };
}

template <typename Words>
std::vector<juce::String> wordsForHosts (const Words& words)
{
    std::vector<juce::String> texts;
    texts.reserve (std::size (words));

    for (const auto& [word, value] : words)
        texts.push_back (juce::String (std::string (word)).replaceCharacter ('_', ' '));

    return texts;
}

template <typename Words, typename Value>
int wordIndex (const Words& words, Value value)
{
    const auto found =
        std::find_if (words.begin(), words.end(), [&] (const auto& word) { return word.second == value; });
    return static_cast<int> (found - words.begin());
}
} // namespace

Parameters::Parameters (juce::AudioProcessor& processor, const SurfaceSource& model)
{
    GroupBuilder focus (processor, "focus", "Focus", ordered);
    x = focus.number ("x", "Focus x", "", { 0, 100 }, 50, placeTexts (model, SurfaceAxis::x));
    y = focus.number ("y", "Focus y", "", { 0, 100 }, 50, placeTexts (model, SurfaceAxis::y));
    width = focus.number ("width", "Width", "mm", logarithmic (1, 200), 25, unitTexts ("mm", 2));
    shape = focus.choice ("shape", "Shape", wordsForHosts (targetShapeWords));
    peakVelocity =
        focus.number ("peak_velocity", "Peak velocity", "mm/s", logarithmic (0.1, 2000), 40, unitTexts ("mm/s", 2));
    focusTime = focus.number ("focus_time", "Focus time", "ms", logarithmic (1, 500), 25, unitTexts ("ms", 2));
    focus.addToProcessor();

    GroupBuilder drive (processor, "drive", "Drive", ordered);
    growth = drive.number ("growth", "Growth", "", { -1, 50 }, -1, unitTexts ("", 2, 0, "chosen"));
    brake = drive.number ("brake", "Brake", "", { 0, 50 }, 0, unitTexts ("", 2, 1.0F + 1e-6F, "as the focus says"));
    method = drive.choice ("method", "Allocation", wordsForHosts (allocationMethodWords));
    voltageLimit = drive.number ("voltage_limit", "Voltage limit", "V", { 0, 500 }, 0,
                                 unitTexts ("V", 1, 1e-6F, "as the focus says"));
    modes = drive.integer ("modes", "Controlled modes", 512, countTexts ("chosen"));
    drive.addToProcessor();

    GroupBuilder triggers (processor, "triggers", "Triggers", ordered);
    notes = triggers.choice ("notes", "Notes play", { "places over the surface", "the focus alone" });
    noteOff = triggers.choice ("note_off", "Note off", { "is ignored", "fades out", "brakes" });
    retrigger = triggers.choice ("retrigger", "Retrigger", { "overlaps", "restarts" });
    focusOnNote = triggers.flag ("focus_on_note", "Focus on the note", false, "focus on the note", "start on the note");
    triggers.addToProcessor();

    GroupBuilder monitor (processor, "monitor", "Monitor", ordered);
    probeX = monitor.number ("probe_x", "Probe x", "", { 0, 100 }, 50, placeTexts (model, SurfaceAxis::x));
    probeY = monitor.number ("probe_y", "Probe y", "", { 0, 100 }, 50, placeTexts (model, SurfaceAxis::y));
    monitorGain = monitor.number ("monitor_gain", "Monitor gain", "dB", { silentDecibels, 60 }, 0,
                                  unitTexts ("dB", 1, silentText, "silent"));
    monitor.addToProcessor();

    GroupBuilder output (processor, "output", "Output", ordered);
    outputTrim = output.number ("output_trim", "Output trim", "dB", { silentDecibels, 0 }, 0,
                                unitTexts ("dB", 1, silentText, "silent"));
    armed = output.flag ("arm", "Arm", true, "armed", "disarmed", false);
    bypassed = output.flag ("bypass", "Bypass", false, "bypassed", "playing");
    output.addToProcessor();
    begin();
}

PlaySettings Parameters::settings() const
{
    PlaySettings now;
    now.xPercent = static_cast<float> (x->get());
    now.yPercent = static_cast<float> (y->get());
    now.widthMillimetres = static_cast<float> (width->get());
    now.shape = targetShapeWords[static_cast<std::size_t> (shape->get())].second;
    now.peakVelocityMillimetresPerSecond = static_cast<float> (peakVelocity->get());
    now.focusTimeMilliseconds = static_cast<float> (focusTime->get());
    now.growth = static_cast<float> (growth->get());
    now.brake = static_cast<float> (brake->get());
    now.method = allocationMethodWords[static_cast<std::size_t> (method->get())].second;
    now.voltageLimitVolts = static_cast<float> (voltageLimit->get());
    now.modeCount = modes->get();
    now.probeXPercent = static_cast<float> (probeX->get());
    now.probeYPercent = static_cast<float> (probeY->get());
    now.noteLayout = static_cast<NoteLayout> (notes->get());
    now.focusOnNote = *focusOnNote;
    return now;
}

PlayControls Parameters::controls() const
{
    const auto gain = [] (const NumberParameter* decibels)
    { return juce::Decibels::decibelsToGain (decibels->get(), silentDecibels); };

    PlayControls now;
    now.notes.noteOff = static_cast<NoteOffBehaviour> (noteOff->get());
    now.notes.retrigger = static_cast<RetriggerBehaviour> (retrigger->get());
    now.notes.focusOnNote = *focusOnNote;
    now.isArmed = *armed && ! *bypassed;
    now.outputTrim = gain (outputTrim);
    now.monitorGain = gain (monitorGain);

    if (const auto limit = voltageLimit->get(); limit > 0)
        now.voltageLimit = limit;

    return now;
}

std::vector<juce::RangedAudioParameter*> Parameters::ofFocus() const
{
    return { x, y, width, shape, peakVelocity, focusTime, growth, brake, method, voltageLimit, modes, probeX, probeY };
}

void Parameters::setFocus (const PlaySettings& settings)
{
    const std::array wanted { settings.xPercent,
                              settings.yPercent,
                              settings.widthMillimetres,
                              static_cast<float> (wordIndex (targetShapeWords, settings.shape)),
                              settings.peakVelocityMillimetresPerSecond,
                              settings.focusTimeMilliseconds,
                              settings.growth,
                              settings.brake,
                              static_cast<float> (wordIndex (allocationMethodWords, settings.method)),
                              settings.voltageLimitVolts,
                              static_cast<float> (settings.modeCount),
                              settings.probeXPercent,
                              settings.probeYPercent };
    const auto parameters = ofFocus();

    for (std::size_t i = 0; i < wanted.size(); ++i)
        setValue (*parameters[i], static_cast<double> (wanted[i]));
}
} // namespace antinode
