#pragma once

#include "BenchWork.h"
#include "PanelParts.h"

#include <Editor/ChartView.h>
#include <antinode_session/SessionOwner.h>

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace antinode
{
/** The surface of a measurement: what is measured, where the sensor is to be aimed, and ceramics with wrong wires.
    [message thread] */
class BenchSurface final : public SurfaceView
{
public:
    BenchSurface();

    void show (const BenchState&);

private:
    void paintOnTop (juce::Graphics&) override;
    void paintAim (juce::Graphics&, juce::Point<float>, const Palette&) const;
    juce::Point<float> pixelsOf (double x, double y) const;

    Eigen::MatrixX2d points;
    std::vector<bool> measured;
    std::vector<WireFinding> findings;
    Eigen::Index aim = -1;
};

/** "31.2 mm from the left edge, 42.1 mm from the lower edge". @param place  m [any] */
juce::String aimInWords (const Surface&, const Eigen::Vector2d& place);

/** What a meter's reading says of the wires of a ceramic. @param expected, read  F, above 0 [any] */
juce::String capacitanceInWords (double expected, double read);

/** A ceramic of the bench: what a meter reads of its wire, and how it answers. [message thread] */
class WireRow final : public juce::Component
{
public:
    static constexpr int height = 26;

    explicit WireRow (std::size_t ceramicToShow);

    /** @param canRead  whether the gain may change: nothing is measured by it */
    void show (const BenchState&, bool canIdentify, bool canRead, bool identifies);

    /** As if the user typed them: nF, V. */
    void enterCapacitance (const juce::String& text);
    void enterTone (const juce::String& text);

    /** Called with a reading of the identify tone over what it should be. */
    std::function<void (double ratio)> onTone;
    std::function<void()> onIdentify;

    juce::String verdict() const { return words.getText(); }

    static void paintHeadings (juce::Graphics&, juce::Rectangle<int>);
    void lookAndFeelChanged() override;
    void resized() override;

private:
    void readCapacitance();
    void readTone();
    juce::String answerInWords (const BenchState&) const;

    std::size_t ceramic;
    double expectedCapacitance = 0, expectedTone = 0; ///< F, V
    juce::String ofMeter;                             ///< What the readings say.
    juce::Label name, words;
    juce::TextButton identify { "Identify" };
    juce::TextEditor capacitance, tone;
};

/** Leads from a drawn device to a measured one: the wires, the points, the retuned device, on the bench or on a tour
    that drives nothing. [message thread] */
class BenchPanel final : public juce::Component, private juce::Timer
{
public:
    /** @param hostToUse  outlives this */
    explicit BenchPanel (AudioHost& hostToUse);
    ~BenchPanel() override;

    /** The device that is drawn. */
    std::function<std::shared_ptr<const DeviceDocument>()> device;

    /** Gets the retuned device once it is saved. */
    std::function<void (std::shared_ptr<const DeviceDocument>)> onSaved;

    /** In which measurements and devices are kept. */
    std::filesystem::path folder;

    // As if the user clicked.

    void begin();
    void stop();
    void answer (PointAnswer);
    void correctRouting();
    void save (const juce::String& name);
    void chooseTour (bool isTour);

    const BenchState& shown() const { return state; }
    const OutputRouting& routing() const { return isTour() ? tourRouting : host.settings().routing; }
    WireRow& row (std::size_t ceramic) { return *rows[ceramic]; }

    /** Takes what has changed. */
    void refresh();

    void lookAndFeelChanged() override;
    void resized() override;

private:
    /** What is scrolled. */
    class Page : public juce::Component
    {
    public:
        juce::Rectangle<int> headings; ///< Of the rows; empty: none are shown.
        void paint (juce::Graphics&) override;
    };

    bool isTour() const { return bench.getSelectedId() == tour; }
    void makeSensor();
    void makeActions();
    void takeSensor();
    void fillInputs();
    BenchQuestion question();
    std::string conditions() const;
    juce::String closedInputs() const;
    bool isOutdated() const;
    bool hasPoint() const;
    void setRouting (const OutputRouting&);
    void scaleAmplifier (std::size_t ceramic, double ratio);
    void makeRows();
    void showRows();
    void showWords();
    juce::String title() const;
    juce::String words() const;
    juce::String outcome() const;
    void layOut();
    void layOutSensor (juce::Rectangle<int>&);
    void timerCallback() override { refresh(); }

    static constexpr int tour = 1, real = 2; ///< Of `bench`.

    AudioHost& host;
    std::shared_ptr<BenchDevice> audio;
    SessionThread<BenchWork> work;
    BenchState state;
    OutputRouting tourRouting = straightRouting();
    juce::String saved;     ///< What became of the last action.
    std::string begunUnder; ///< conditions() of the measurement, with the next line.
    Eigen::VectorXd begunLimits;
    Page page;
    juce::Viewport viewport;
    juce::ComboBox bench, input, syncInput;
    juce::TextEditor sensitivity, inputRange, level, deviceName;
    std::array<juce::Label, 6> names;
    juce::TextButton beginButton { "Begin" }, stopButton { "Stop" }, measureButton { "Measure here" },
        skipButton { "Skip" }, againButton { "Repeat" }, correctButton { "Correct the routing" },
        goOnButton { "Go on" }, saveButton { "Save and load" };
    juce::Label heading, text;
    BenchSurface surface;
    std::vector<std::unique_ptr<WireRow>> rows;
    std::shared_ptr<const DeviceDocument> rowsOf; ///< Whose ceramics the rows are.
    ChartView chart { "Response before and after" };
    juce::TextEditor checklist;
    int openInputs = -1; ///< That the choices of inputs show.
};
} // namespace antinode
