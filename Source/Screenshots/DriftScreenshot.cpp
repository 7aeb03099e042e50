#include "Screenshots.h"

#include <Editor/EditorContent.h>

#include <antinode_engine/PlateModel.h>
#include <antinode_focus/Detuning.h>
#include <antinode_numerics/RandomNumbers.h>

#include <array>
#include <chrono>
#include <memory>
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
} // namespace antinode
