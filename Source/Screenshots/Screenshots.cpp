#include "Screenshots.h"

#include <Editor/EditorContent.h>
#include <Plate/PlateContent.h>
#include <Standalone/MainWindow.h>
#include <Touch/TouchContent.h>
#include <antinode_documents/Library.h>
#include <antinode_engine/PlateModel.h>
#include <antinode_engine/VoltageSynthesiser.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/Detuning.h>
#include <antinode_focus/FocusDescription.h>
#include <antinode_numerics/Statistics.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <thread>

namespace antinode
{
namespace
{
constexpr double driftRate = 48000, driftStep = 4e-4, jump = 5e-3, secondsPlayed = 32;
constexpr int driftBlock = 480, listening = 7, blocksPerFocus = 20, blocksPerPause = 25, blocksPerStep = 500,
              blockOfJump = 1500;

/** The staple off its model: frequencies move while it is played, and jump once. */
class DriftingStaple
{
public:
    explicit DriftingStaple (const ModalModel& model) : truth (detuned (model, { 5e-4, 0.02, 0.01, 0 }, 4))
    {
        move (0.004);
    }

    void move (double drift)
    {
        truth.angularFrequencies *= 1 + drift;
        plate = std::make_unique<PlateModel> (truth, Playback { Reconstruction::bandLimited, driftRate },
                                              truth.participation.col (listening).transpose().eval());
    }

    Eigen::RowVectorXd hear (const Eigen::MatrixXd& volts)
    {
        Eigen::MatrixXd signal (1, volts.cols());
        plate->process (volts, signal);
        return 100 * signal + 1e-5 * random.normal (volts.cols()).transpose();
    }

private:
    ModalModel truth;
    std::unique_ptr<PlateModel> plate;
    RandomNumbers random { 5 };
};

void playFollowed (AntinodeProcessor& processor)
{
    const auto model = processor.session().snapshot()->model;
    DriftingStaple staple (*model);
    juce::AudioBuffer<float> audio (processor.getTotalNumOutputChannels(), driftBlock);
    juce::MidiBuffer midi;
    Eigen::RowVectorXd heard = Eigen::RowVectorXd::Zero (driftBlock);
    const auto blocks = static_cast<int> (secondsPlayed * driftRate / driftBlock);

    for (int i = 0; i < blocks; ++i)
    {
        if (i % blocksPerFocus == 0)
            processor.session().fire (0.7);

        // A plate that is made again is at rest: seldom, so that most windows have no such break.
        if (i > 0 && i % blocksPerStep == 0)
            staple.move (i == blockOfJump ? jump : driftStep);

        for (int n = 0; n < driftBlock; ++n)
            audio.setSample (0, n, static_cast<float> (heard[n]));

        processor.processBlock (audio, midi);
        Eigen::MatrixXd volts (model->actuators(), driftBlock);

        for (Eigen::Index k = 0; k < volts.rows(); ++k)
            volts.row (k) =
                model->fullScaleVoltage
                * Eigen::Map<const Eigen::RowVectorXf> (audio.getReadPointer (static_cast<int> (k)), driftBlock)
                      .cast<double>();

        heard = staple.hear (volts);

        // Windows are followed as quickly as they come in.
        if (i % blocksPerPause == 0)
            std::this_thread::sleep_for (std::chrono::milliseconds (150));
    }
}
} // namespace

void takeDrift (const juce::File& file)
{
    AntinodeProcessor processor (8, juce::AudioProcessor::wrapperType_Undefined);
    Editor editor (processor);
    editor.setSize (1280, 800);
    processor.prepareToPlay (driftRate, driftBlock);
    processor.parameters().arm().setValueNotifyingHost (1);
    processor.parameters().find ("notes")->setValueNotifyingHost (1); // no designs for unused notes
    FollowingSettings following;
    following.sensor = FollowingSensor::ceramicCurrent;
    following.ceramic = listening;
    processor.session().following().setSettings (following);
    processor.session().waitUntilSettled();
    playFollowed (processor);
    auto& content = editor.content();
    content.showPanel ("Drift");

    refreshUntil (content, [&] { return content.isSettled(); });
    writePicture (editor, file);
}

void takeDevice (const juce::File& file, int width, int height, bool isDark)
{
    AntinodeProcessor processor (10, juce::AudioProcessor::wrapperType_Undefined);
    Editor editor (processor);
    editor.setSize (width, height);
    processor.prepareToPlay (driftRate, driftBlock);
    processor.parameters().find ("notes")->setValueNotifyingHost (1); // no designs for unused notes
    auto& content = editor.content();
    content.setDark (isDark);
    content.showPanel ("Device");
    content.devicePanel().begin ("rounded rectangle");
    refreshUntil (content, [&] { return processor.focus()->description.name == "suited" && content.isSettled(); });
    constexpr int mode = 4;
    content.devicePanel().showMode (mode);
    auto& draft = content.deviceDraft();
    draft.ceramics = { 1 };
    refreshUntil (content, [&] { return content.isSettled() && content.draftShown()->question.mode == mode; });
    draft.drag (withShifted (draft.document(), draft.ceramics, { 0, -5.5 }));
    content.refresh (0);
    refreshUntil (content, [&] { return content.isSettled(); });
    writePicture (editor, file);
}

namespace
{
constexpr double rate = 96000;
constexpr int block = 960, blocks = 12, width = 1040, height = 640;

/** The voltages of a focus on the loaded device, from its trigger on, in full scales. */
Eigen::MatrixXd renderVoltages (const ModalModel& model, const std::string& focus)
{
    const Playback playback { Reconstruction::bandLimited, rate };
    const auto document = readFocusDocument (loadDocument (LibraryKind::focus, focus), focus);
    const auto design = designFocus (model, document.description, playback);
    Eigen::MatrixXd voltages (model.actuators(), block * blocks);
    VoltageSynthesiser (design.program, playback).process (0, voltages);
    return voltages / model.fullScaleVoltage;
}

void play (PlateProcessor& processor, const Eigen::MatrixXd& voltages, PlateContent& content)
{
    juce::MidiBuffer midi;

    for (int b = 0; b < blocks; ++b)
    {
        juce::AudioBuffer<float> buffer (processor.getTotalNumInputChannels(), block);
        buffer.clear();

        for (int i = 0; i < std::min (static_cast<int> (voltages.rows()), buffer.getNumChannels()); ++i)
            for (int n = 0; n < block; ++n)
                buffer.setSample (i, n, static_cast<float> (voltages (i, b * block + n)));

        processor.processBlock (buffer, midi);
        content.refresh (static_cast<double> (block) / rate);
    }
}
} // namespace

void takePlate (const juce::File& file)
{
    PlateProcessor processor (32, juce::AudioProcessor::wrapperType_Undefined);
    processor.setNonRealtime (true);
    processor.load (deviceDocument ("glass-148x210"));
    processor.prepareToPlay (rate, block);
    processor.session().waitUntilSettled();
    PlateEditor editor (processor);
    editor.setSize (width, height);
    auto& content = editor.content();
    play (processor, renderVoltages (*processor.session().snapshot()->model, "glass-finger"), content);

    refreshUntil (content, [&] { return content.picture() != nullptr && content.picture()->step > 0; });
    content.holdAt (PlatePath::capturedFrames / 2);
    writePicture (editor, file);
}

namespace
{
constexpr double touchRate = 48000;
constexpr int touchBlock = 480, touchBlocks = 60;

/** A tone that swells, a burst, and a low tone. */
float trackSample (int finger, int n)
{
    const auto time = n / touchRate;
    const auto tone = [&] (double frequency) { return std::sin (2 * std::numbers::pi * frequency * time); };
    const double values[] = { 0.9 * tone (200) * (0.6 + 0.4 * tone (4)),
                              0.7 * tone (330) * std::exp (-8 * std::fmod (time, 0.3)), 0.5 * tone (80) };
    return static_cast<float> (values[finger]);
}

void playTracks (TouchProcessor& processor, TouchContent& content)
{
    juce::MidiBuffer midi;

    for (int b = 0; b < touchBlocks; ++b)
    {
        juce::AudioBuffer<float> buffer (processor.getTotalNumOutputChannels(), touchBlock);
        buffer.clear();

        for (int k = 0; k < 3; ++k)
            for (int n = 0; n < touchBlock; ++n)
                buffer.setSample (k, n, trackSample (k, b * touchBlock + n));

        processor.processBlock (buffer, midi);
        content.refresh (touchBlock / touchRate);
    }
}

/** Four fingers on the glass plate, three of which play, and a focus for notes. */
void putDown (TouchProcessor& processor)
{
    processor.load (deviceDocument ("glass-148x210"));
    processor.parameters().setValues ({ { "finger1_x", 22 },
                                        { "finger1_y", 35 },
                                        { "finger1_state", 2 },
                                        { "finger1_load", 2 },
                                        { "finger2_x", 55 },
                                        { "finger2_y", 70 },
                                        { "finger2_state", 2 },
                                        { "finger2_load", 2 },
                                        { "finger3_x", 80 },
                                        { "finger3_y", 30 },
                                        { "finger3_state", 2 },
                                        { "finger3_load", 3 },
                                        { "finger4_x", 40 },
                                        { "finger4_y", 22 },
                                        { "finger4_state", 1 },
                                        { "finger4_load", 1 } });
    processor.loadFocus (focusDocument ("glass-centre"));
    processor.prepareToPlay (touchRate, touchBlock);
}

/** Plays until there is something to see. */
void playUntilSeen (TouchProcessor& processor, TouchContent& content)
{
    refreshUntil (content, [&] { return content.hasPicture() && content.volts().contains ("5 ms: "); });
    playTracks (processor, content);
}
} // namespace

void takeTouch (const juce::File& file)
{
    TouchProcessor processor (32, juce::AudioProcessor::wrapperType_Undefined);
    processor.setNonRealtime (true);
    putDown (processor);
    TouchEditor editor (processor);
    playUntilSeen (processor, editor.content());
    writePicture (editor, file);
}

void takeTouchStandalone (const juce::File& file)
{
    TouchHost host (SettingsFile ({}), false);
    host.processor().setNonRealtime (true);
    putDown (host.processor());
    MainComponent window (host);
    window.setSize (1500, 720);
    host.arm().setValueNotifyingHost (1);
    window.showSettings ("Inputs");
    playUntilSeen (host.processor(), window.touchEditor()->content());
    window.update();
    writePicture (window, file);
}
} // namespace antinode
