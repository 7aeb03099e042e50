#include "FieldFrames.h"

#include "EditorLook.h"

#include <antinode_base/Watch.h>
#include <antinode_focus/Prediction.h>
#include <antinode_reports/PlateCharts.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
constexpr int mapCells = 160; // along the longer side

Eigen::VectorXd velocitiesAt (const ModalModel& model, const FocusDesign& design, double fromFocus)
{
    const auto time = std::max (0.0, design.program.focusTime + fromFocus);
    return modalVelocities (model, predictStates (model, design.program, time));
}

/** @param velocities  N_c x frames */
void fill (FieldFrames& frames, const ModalModel& model, const Eigen::MatrixXd& velocities)
{
    Eigen::MatrixXd fields = model.shapes * velocities;

    if (model.surface.kind == SurfaceKind::plate)
        frames.maps = fieldMaps (model.surface, fields, mapCells);
    else
        frames.lines = std::move (fields);
}

FieldFrames framesOfFocus (const ModalModel& model, const Eigen::VectorXd& velocities)
{
    FieldFrames frames;
    frames.focusVelocities = velocities;
    frames.focusField = model.shapes * velocities;
    frames.largest = frames.focusField (pointsOn (model.surface)).cwiseAbs().maxCoeff();
    fill (frames, model, velocities);
    return frames;
}
} // namespace

FieldFrames predictFocus (const ModalModel& model, const FocusDesign& design)
{
    return framesOfFocus (model, velocitiesAt (model, design, 0));
}

FieldFrames makeFrames (const ModalModel& model, const Eigen::MatrixXd& velocities)
{
    const Eigen::MatrixXd fields = model.shapes * velocities;
    Eigen::Index largest = 0;
    fields (pointsOn (model.surface), Eigen::all).cwiseAbs().colwise().maxCoeff().maxCoeff (&largest);
    auto frames = framesOfFocus (model, velocities.col (largest));
    fill (frames, model, velocities);
    return frames;
}

FieldFrames stillFrames (const ModalModel& model)
{
    return framesOfFocus (model, Eigen::VectorXd::Zero (model.coordinates()));
}

std::shared_ptr<const FieldFrames> predictFrames (const ModalModel& model, const FocusDesign& design)
{
    auto frames = std::make_shared<FieldFrames> (predictFocus (model, design));
    Eigen::MatrixXd velocities (model.coordinates(), FieldFrames::count);

    for (int i = 0; i < FieldFrames::count; ++i)
    {
        checkWatch();
        velocities.col (i) = velocitiesAt (model, design, FieldFrames::frameTime (i));
    }

    fill (*frames, model, velocities);
    return frames;
}

namespace
{
constexpr double framesPerSecond = 24;
constexpr int valueWidth = 124;

juce::String timeText (double frame)
{
    const auto milliseconds = 1000 * FieldFrames::frameTime (juce::roundToInt (frame));
    return (milliseconds < 0 ? juce::String::fromUTF8 ("focus \xE2\x88\x92 ") : juce::String ("focus + "))
           + juce::String (std::abs (milliseconds), 2) + " ms";
}
} // namespace

Timeline::Timeline()
{
    setTitle ("Time");
    play.setButtonText ("Play");
    play.setTitle ("Play around the focus");
    play.setClickingTogglesState (true);
    play.setTooltip ("Plays the field in slow motion from 3 ms before to 3 ms after the focus. Key: P");
    play.onStateChange = [this] { play.setButtonText (isPlaying() ? "Pause" : "Play"); };
    play.onClick = [this] { position = place.getValue(); };
    focus.setButtonText ("Focus");
    focus.setTitle ("Show the focus");
    focus.setTooltip ("Shows the instant of the focus. Key: F");
    focus.onClick = [this]
    {
        setPlaying (false);
        place.setValue (FieldFrames::atFocus);
    };
    place.setSliderStyle (juce::Slider::LinearHorizontal);
    place.setTextBoxStyle (juce::Slider::TextBoxRight, true, valueWidth, 20);
    place.setRange (0, FieldFrames::count - 1, 1);
    place.textFromValueFunction = timeText;
    place.setValue (FieldFrames::atFocus, juce::dontSendNotification);
    place.updateText();
    place.setDoubleClickReturnValue (true, FieldFrames::atFocus);
    place.setTitle ("Time from the focus");
    place.setTooltip ("Displayed instant relative to the focus, ms.");
    place.setWantsKeyboardFocus (true);
    addAndMakeVisible (play);
    addAndMakeVisible (focus);
    addAndMakeVisible (place);
}

int Timeline::frame() const
{
    return juce::roundToInt (place.getValue());
}

void Timeline::advance (double seconds)
{
    if (! isPlaying())
        return;

    position = std::fmod (position + seconds * framesPerSecond, FieldFrames::count - 1);
    place.setValue (std::floor (position), juce::dontSendNotification);
}

void Timeline::paint (juce::Graphics& g)
{
    g.fillAll (EditorLook::findPalette (*this).panel);
}

void Timeline::resized()
{
    auto area = getLocalBounds().reduced (8, 6);
    play.setBounds (area.removeFromLeft (60));
    area.removeFromLeft (6);
    focus.setBounds (area.removeFromLeft (60));
    area.removeFromLeft (8);
    place.setBounds (area);
}
} // namespace antinode
