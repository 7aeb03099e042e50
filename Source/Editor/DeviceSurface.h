#pragma once

#include "DeviceDraft.h"
#include "DraftView.h"
#include "SurfaceView.h"

#include <Processor/AntinodeProcessor.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace antinode
{
/** The device while it is drawn: a mode of it in colours, its edges, ceramics, feet and masses, which are dragged, and
   the spot of the focus. What is wrong with a ceramic is written next to it. [message thread] */
class DeviceSurface final : public SurfaceView
{
public:
    DeviceSurface (AntinodeProcessor&, DeviceDraft&);

    void show (std::shared_ptr<const DraftPicture>);

    /** Draws what has changed. */
    void refresh();

    /** The middle of a ceramic, in pixels. */
    juce::Point<float> middleOf (std::size_t ceramic);

    juce::Point<float> spot() const { return pixels (spotPlace); }

    /** What can be done at a place. @param at  in pixels of this component */
    juce::PopupMenu menuAt (juce::Point<float> at);

    void mouseMove (const juce::MouseEvent&) override;
    void mouseDown (const juce::MouseEvent&) override;
    void mouseDrag (const juce::MouseEvent&) override;
    void mouseUp (const juce::MouseEvent&) override;
    bool keyPressed (const juce::KeyPress&) override;

private:
    enum class Handle
    {
        none,
        spot,
        ceramic,
        size,
        turn,
        point
    };

    /** What of the document is drawn, in pixels. */
    struct Drawn
    {
        juce::Path body;
        std::vector<juce::Path> ceramics, edges;
        std::vector<juce::Point<float>> points;
        std::vector<std::string> edgeNames;
    };

    struct Guides
    {
        std::optional<double> x, y; ///< mm
    };

    const Drawn& drawn();
    juce::Point<float> pixelsOf (const Eigen::Vector2d& millimetres) const;
    Eigen::Vector2d millimetresAt (juce::Point<float>) const;
    juce::Path pathOfCeramic (const DrawnCeramic&) const;
    Handle handleAt (juce::Point<float>);
    std::optional<std::size_t> ceramicAt (juce::Point<float>);
    std::optional<std::size_t> pointAt (juce::Point<float>);
    std::optional<std::size_t> edgeAt (juce::Point<float>);
    std::optional<juce::Point<float>> cornerOf (Handle);
    void selectAt (juce::Point<float>, bool isMore);
    void dragCeramics (const Eigen::Vector2d& by, bool isFree);
    void dragCorner (juce::Point<float>, bool isFree);
    Eigen::Vector2d snapped (const Eigen::Vector2d& place, bool isFree);
    juce::PopupMenu edgeMenu();
    void addCeramic (CeramicShape, const Eigen::Vector2d& at);
    void addPoint (const DrawnPoint&);
    void removeSelected();
    void paintOnTop (juce::Graphics&) override;
    void paintBody (juce::Graphics&, const Palette&);
    void paintCeramics (juce::Graphics&, const Palette&);
    void paintFaults (juce::Graphics&, const Palette&);
    void paintPoints (juce::Graphics&, const Palette&);
    void paintGuides (juce::Graphics&, const Palette&);
    void paintSpot (juce::Graphics&, const Palette&) const;

    DeviceDraft& draft;
    Place spotPlace;
    std::shared_ptr<const DraftPicture> picture;
    Drawn cached;
    int cachedChange = -1, paintedChange = -1;
    juce::Rectangle<float> cachedPlot;
    Handle held = Handle::none;
    nlohmann::json heldDocument;                      ///< Before it was dragged.
    Eigen::Vector2d heldAt = Eigen::Vector2d::Zero(); ///< mm
    std::size_t heldCeramic = 0;
    Guides guides;
    float shownSpot = -1;
};
} // namespace antinode
