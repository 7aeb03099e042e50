#pragma once

#include "DraftControls.h"
#include "DraftView.h"
#include "PlaceSearch.h"

#include <juce_gui_basics/juce_gui_basics.h>

#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace antinode
{
/** What the drawn device is, one thing below the other, with the present focus on it as two large numbers. Beside it is
    the DeviceSurface. [message thread] */
class DevicePanel final : public juce::Component
{
public:
    explicit DevicePanel (DeviceDraft&);

    /** Starts a search of places for the ceramics, or ends it. */
    std::function<void (bool shouldRun)> onPlace;

    /** Shows what has changed. @param picture  the newest one, or none */
    void refresh (const std::shared_ptr<const DraftPicture>& picture, const PlaceProgress&);

    /** Puts the ceramics where they were found to be better. */
    void takePlaces();

    /** The mode that is shown, from 0; none: the surface at rest. */
    std::optional<int> mode() const { return shownMode; }
    void showMode (std::optional<int>);

    /** Begins a device from a template. */
    void begin (const std::string& nameOfTemplate);

    /** The same device by another name, so that the one before stays as it is. */
    void duplicate();

    /** Writes the device as a file that the command line takes. */
    void saveTo (const juce::File&);

    /** A row by its name, for tests; nullptr: there is none. */
    template <typename Row>
    Row* find (const juce::String& name) const
    {
        for (const auto& row : rows)
            if (auto* const found = dynamic_cast<Row*> (row.get()); found != nullptr && found->isVisible())
                if (found->getName() == name)
                    return found;

        return nullptr;
    }

    void resized() override;
    void paint (juce::Graphics&) override;
    void lookAndFeelChanged() override { repaint(); }

private:
    /** The page that is scrolled. */
    class Page : public juce::Component
    {
    public:
        void paint (juce::Graphics&) override;

        std::vector<std::pair<juce::String, juce::Rectangle<int>>> headings;
    };

    /** A button, and whether the drawn device has such a thing. */
    struct Offer
    {
        std::unique_ptr<juce::TextButton> button;
        std::function<bool()> isThere;
    };

    /** What stands below one another: rows that the device has, and buttons side by side. */
    struct Section
    {
        juce::String name;
        std::vector<juce::Component*> rows;
        std::vector<juce::Component*> buttons;
    };

    void addNumber (Section&, DraftNumber::Kind);
    void addChoice (Section&, DraftChoice::Kind);
    juce::TextButton& addButton (Section&, const juce::String& name, const juce::String& tooltip,
                                 std::function<void()> action, std::function<bool()> isThere);
    void makeDevice();
    void makeSizes();
    void makeLayers();
    void makeEdges();
    void addSupports (Section&);
    void makeCeramics();
    void addCeramicShape (Section&);
    void addCeramicKeys (Section&);
    void makePlacing();
    void makeSearch();
    void showSearch (const PlaceProgress&);
    void makePoints();
    void chooseTemplate (juce::Component& at);
    void chooseFile();
    void addPoint (double stiffness, double mass);
    void stepMode (int by);
    bool isOfPlate() const;
    bool hasCeramics() const;
    void layOut();
    void paintFigures (juce::Graphics&, juce::Rectangle<int>) const;
    juce::String modeText() const;

    DeviceDraft& draft;
    std::shared_ptr<const DraftPicture> picture;
    std::vector<std::unique_ptr<DraftRow>> rows;
    std::vector<Offer> offers;
    std::vector<Section> sections;
    juce::Label deviceName, modeName, searchText;
    juce::TextButton* searchButton = nullptr;
    PlaceProgress search;
    juce::TextButton modeBefore, modeAfter;
    Page page;
    juce::Viewport viewport;
    std::unique_ptr<juce::FileChooser> chooser;
    std::optional<int> shownMode = 0;
    int sideOfRow = 0, countOfRow = 5;
    double distanceOfRow = 6; ///< mm
    int seenChange = -1;
    CeramicChoice seenCeramics;
    std::optional<std::size_t> seenPoint;
    std::string seenEdge;
};
} // namespace antinode
