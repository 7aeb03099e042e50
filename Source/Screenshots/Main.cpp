#include "Screenshots.h"

#include <Standalone/MainWindow.h>

#include <antinode_numerics/Statistics.h>

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

namespace
{
constexpr double sampleRate = 96000;
constexpr int blockSize = 960;

/** A picture: its file, its size, and what it shows. */
struct Screenshot
{
    std::string file;
    int width, height;
    std::string device, focus;
    bool isDark;
    bool hasFingers = false; ///< Rests two fingers and shows what is felt.
};

/** Fires a few times, so that meters and the live trace show something. */
void play (antinode::AntinodeProcessor& processor, antinode::EditorContent& content)
{
    constexpr int blocks = 50, blocksPerFocus = 16;
    juce::AudioBuffer<float> audio (processor.getTotalNumOutputChannels(), blockSize);
    juce::MidiBuffer midi;

    for (int i = 0; i < blocks; ++i)
    {
        if (i % blocksPerFocus == 0)
            processor.session().fire (0.7);

        processor.processBlock (audio, midi);
        content.refresh (static_cast<double> (blockSize) / sampleRate);
    }
}

/** Loads and plays what is wanted. */
void show (const Screenshot& wanted, antinode::AntinodeProcessor& processor, antinode::Editor& editor)
{
    processor.load (antinode::deviceDocument (wanted.device), antinode::focusDocument (wanted.focus));
    processor.prepareToPlay (sampleRate, blockSize);
    processor.parameters().arm().setValueNotifyingHost (1);
    processor.parameters().find ("notes")->setValueNotifyingHost (1); // no designs for unused notes
    auto& content = editor.content();
    content.setDark (wanted.isDark);
    const auto isSettled = [&content] { return content.isSettled(); };
    processor.session().waitUntilSettled();
    antinode::refreshUntil (content, isSettled);

    if (wanted.hasFingers)
    {
        content.surface().fingers().rest ("medium", 0.15, 0.11);
        content.surface().fingers().rest ("firm", 0.03, 0.05);
        content.surface().fingers().setKnown (1, false);
        content.showPanel ("Felt");
        processor.session().waitUntilSettled();
        antinode::refreshUntil (content, isSettled);
    }

    play (processor, content);
}

void takeEditor (const Screenshot& wanted, const juce::File& folder)
{
    antinode::AntinodeProcessor processor (32, juce::AudioProcessor::wrapperType_Undefined);
    antinode::Editor editor (processor);
    editor.setSize (wanted.width, wanted.height);
    show (wanted, processor, editor);
    antinode::writePicture (editor, folder.getChildFile (wanted.file + ".png"));
}

/** What a sensor gives of a tone of 200 Hz and two resonances above its noise, on input 3. */
void feedInput (antinode::AudioCallback& callback)
{
    constexpr int samples = 1 << 15;
    const std::array<std::array<double, 2>, 3> lines { { { 200, 0.02 }, { 1378, 0.3 }, { 8234, 0.1 } } }; // Hz, peak
    const auto noise = antinode::RandomNumbers (1).normal (samples);
    std::vector<float> heard (samples);

    for (int n = 0; n < samples; ++n)
    {
        auto sum = 1e-3 * noise[n];

        for (const auto& [frequency, peak] : lines)
            sum += peak * std::sin (2 * std::numbers::pi * frequency * n / sampleRate);

        heard[static_cast<std::size_t> (n)] = static_cast<float> (sum);
    }

    juce::BigInteger inputs;
    inputs.setBit (2);
    callback.prepare (sampleRate, blockSize, {}, inputs);
    callback.input().write (heard.data(), samples);
}

/** The bench on its tour: at the first point, with the wires that it finds wrong, and at the end. */
void takeBench (const Screenshot& wanted, const juce::File& folder)
{
    using antinode::BenchStep;
    antinode::StandaloneHost host (antinode::SettingsFile ({}), false);
    antinode::MainComponent window (host);
    auto& bench = window.benchPanel();
    const auto measurements = juce::File::createTempFile ({});
    bench.folder = measurements.getFullPathName().toStdString();
    window.setSize (wanted.width, wanted.height);
    show (wanted, host.processor(), *window.fociEditor());
    window.showSettings ("Bench");
    const auto until = [&bench] (BenchStep step)
    {
        while (bench.shown().step != step)
        {
            std::this_thread::sleep_for (std::chrono::milliseconds (10));
            bench.refresh();
        }
    };
    const auto take = [&] (const char* name)
    { antinode::writePicture (window, folder.getChildFile (wanted.file + name + ".png")); };
    bench.begin();
    until (BenchStep::aiming);
    take ("-aim");
    bench.answer (antinode::PointAnswer::measure);
    until (BenchStep::wires);
    take ("-wires");
    bench.correctRouting();

    while (bench.shown().step != BenchStep::done)
    {
        bench.answer (antinode::PointAnswer::measure);
        std::this_thread::sleep_for (std::chrono::milliseconds (10));
        bench.refresh();
    }

    take ("-done");
    measurements.deleteRecursively();
}

void takeStandalone (const Screenshot& wanted, const juce::File& folder)
{
    antinode::StandaloneHost host (antinode::SettingsFile ({}), false);
    antinode::MainComponent window (host);
    window.setSize (wanted.width, wanted.height);
    show (wanted, host.processor(), *window.fociEditor());
    window.showSettings ("Routing");
    window.update();
    antinode::writePicture (window, folder.getChildFile (wanted.file + ".png"));
    window.showSettings ("Audio device");
    feedInput (host.callback());
    window.update();
    antinode::writePicture (window, folder.getChildFile (wanted.file + "-input.png"));
}
} // namespace

void antinode::writePicture (juce::Component& component, const juce::File& file)
{
    const auto image = component.createComponentSnapshot (component.getLocalBounds(), true, 1);
    file.deleteFile();
    juce::FileOutputStream stream (file);
    juce::PNGImageFormat().writeImageToStream (image, stream);
    std::printf ("%s\n", file.getFullPathName().toRawUTF8());
}

/** Usage: antinode_screenshots FOLDER */
int main (int argumentCount, char* arguments[])
{
    if (argumentCount != 2)
        return 2;

    const juce::ScopedJuceInitialiser_GUI juceSession;
    const auto folder = juce::File::getCurrentWorkingDirectory().getChildFile (arguments[1]);
    const Screenshot screenshots[] = {
        { "editor-800x500", 800, 500, "staple", "demonstrator", true },
        { "editor-plate", 1280, 800, "glass-148x210", "glass-finger", true },
        { "editor-fingers", 1280, 800, "glass-148x210", "glass-finger", true, true },
    };

    for (const auto& screenshot : screenshots)
        takeEditor (screenshot, folder);

    antinode::takeDevice (folder.getChildFile ("editor-device.png"), 1280, 800, true);
    antinode::takeDrift (folder.getChildFile ("editor-drift.png"));
    antinode::takePlate (folder.getChildFile ("plate-plugin.png"));
    antinode::takeTouch (folder.getChildFile ("touch-plugin.png"));
    antinode::takeTouchStandalone (folder.getChildFile ("standalone-touch.png"));
    takeBench ({ "bench", 1280, 800, "phone", "phone-thumb", true }, folder);
    takeStandalone ({ "standalone", 1500, 852, "phone", "phone-thumb", true }, folder);
}
