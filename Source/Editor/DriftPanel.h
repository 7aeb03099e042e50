#pragma once

#include "ChartView.h"

#include <antinode_model/ModalModel.h>
#include <antinode_reports/Chart.h>
#include <antinode_session/Following.h>
#include <juce_gui_basics/juce_gui_basics.h>

#include <array>
#include <functional>
#include <memory>

namespace antinode
{
/** The common drift of a followed device over time, with twice its deviation to both sides; windows that were not
    explained are gaps. [any] */
LineChart driftChart (const FollowingStatus&);

/** What a drift panel shows and changes, of whatever tracks. */
struct DriftPanelSource
{
    FollowingRequests& following;                             ///< Outlives the panel.
    std::function<std::shared_ptr<const ModalModel>()> model; ///< None: it is not solved yet.
    std::function<void (const FollowingSettings&)> change;
    std::function<void()> reset; ///< Forgets the drift, and can be undone; none: the panel does both.
};

/** The sensor that follows the drift of the device, what it says, and what becomes of it. [message thread] */
class DriftPanel final : public juce::Component
{
public:
    explicit DriftPanel (DriftPanelSource);

    /** Shows what has changed. */
    void refresh();

    /** What it says at the moment, for screen readers and tests. */
    juce::String words() const { return sentence.getText(); }

    juce::ComboBox& sensorChoice() { return sensor; }
    juce::ComboBox& ceramicChoice() { return ceramic; }
    juce::Label& place (int axis) { return places[static_cast<std::size_t> (axis)]; } ///< 0: x, 1: y; mm.
    juce::Button& freezeButton() { return freeze; }
    juce::Button& resetButton() { return reset; }
    juce::Button& undoButton() { return undo; }

    void resized() override;
    void lookAndFeelChanged() override;

private:
    void change (const FollowingSettings&);
    void takePlace();
    void showSettings (const FollowingSettings&);
    void listCeramics (int count);

    void forget();

    DriftPanelSource source;
    std::shared_ptr<const KnownDrift> forgotten; ///< What Undo brings back.
    juce::ComboBox sensor, ceramic;
    std::array<juce::Label, 2> placeNames, places;
    juce::ToggleButton freeze { "Freeze" };
    juce::TextButton reset { "Reset" }, undo { "Undo" };
    juce::Label sentence;
    ChartView chart { "Drift that all frequencies share" };
    FollowingSettings shown;
    std::shared_ptr<const FollowingStatus> status;
    juce::String fault; ///< Of the place that was typed last.
};
} // namespace antinode
