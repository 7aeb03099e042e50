#include "Screenshots.h"

#include <Plate/PlateContent.h>
#include <antinode_documents/Library.h>
#include <antinode_engine/VoltageSynthesiser.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/FocusDescription.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>

namespace antinode
{
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
} // namespace antinode
