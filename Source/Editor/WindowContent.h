#pragma once

#include "EditorLook.h"

#include <antinode_session/UserMessages.h>
#include <juce_gui_basics/juce_gui_basics.h>

#include <functional>
#include <vector>

namespace antinode
{
/** The messages of a window, the worst first, one below the other: as high as they need. [message thread] */
class StatusLine final : public juce::Component, public juce::SettableTooltipClient
{
public:
    StatusLine();

    /** @param present  in any order, those whose cause lasts
        @param figures  what stands at the right
        @param seconds  since the last call */
    void show (std::vector<UserMessage> present, const juce::String& figures, double seconds);

    /** Shows a sentence for some seconds, or until the next one, for example why a click had no effect. */
    void say (const juce::String& sentence);

    /** The worst message. */
    juce::String text() const;
    Urgency urgency() const;

    /** All of them. */
    const std::vector<UserMessage>& messages() const { return shown; }

    /** Pixels that the messages need. */
    int wantedHeight() const;

    /** Called after it has become another one. */
    std::function<void()> onHeight;

    void paint (juce::Graphics&) override;

private:
    std::vector<UserMessage> shown;
    juce::String said, figuresShown;
    double saidFor = 0; ///< s
};

/** The commands of a window, from both ends; the theme is one in every window. [message thread] */
class TopBar final : public juce::Component
{
public:
    TopBar();

    juce::TextButton theme;

    /** At the left, after those that are there: narrower where there is no room. */
    void addLeft (juce::Component&, int widest);

    /** At the right, before those that are there. @param gap  beyond it */
    void addRight (juce::Component&, int width, int gap = 6);

    void paint (juce::Graphics&) override;
    void resized() override;

private:
    struct Item
    {
        juce::Component* component;
        int width, gap;
    };

    std::vector<Item> left, right;
};

/** What a content needs, pixels at scale 1. */
struct ContentSizes
{
    int leastWidth = 0, leastHeight = 0; ///< All is reachable from here on.
    int roomyWidth = 0, roomyHeight = 0; ///< It grows with its window from here on.
};

/** By how much a content is drawn larger in a window: as wanted, as far as all of it stays reachable.
    @param wanted  0: as large as suits the window [any] */
double windowScale (int width, int height, const ContentSizes&, double wanted);

/** Shows the tooltips of components inside its parent, except those with a closer instance: JUCE's shows those of the
   whole window, so that two show the same. [message thread] */
class LocalTooltips final : public juce::TooltipWindow
{
public:
    using TooltipWindow::TooltipWindow;

    juce::String getTipFor (juce::Component&) override;
};

/** All that an editor shows, in a plain component for any window: commands on top, messages at the bottom, and between
    them what a role lays out. Nothing in it runs by itself: whoever has it calls refresh(). [message thread] */
class WindowContent : public juce::Component
{
public:
    /** How large it is, and how often it is refreshed. */
    struct Shape
    {
        ContentSizes sizes;
        int usualWidth = 0, usualHeight = 0, framesPerSecond = 0, barHeight = 0;
    };

    ~WindowContent() override { setLookAndFeel (nullptr); }

    const Shape& shape() const { return windowShape; }

    /** Shows what has changed. @param seconds  since the last call */
    virtual void refresh (double seconds) = 0;

    void setDark (bool isDark);
    bool isDark() const { return look.palette().isDark; }

    /** Called after it has become dark or light. */
    std::function<void()> onTheme;

    /** What the window around has to say beside it; none: nothing. */
    std::function<std::vector<UserMessage>()> moreMessages;

    StatusLine& statusLine() { return status; }

    void paint (juce::Graphics&) override;
    void resized() final;

protected:
    static constexpr int gap = 6;

    /** @param title  the plug-in's name */
    WindowContent (const juce::String& title, const Shape&);

    /** To be called when all is made. */
    void begin();

    std::vector<UserMessage> messagesBeside() const;

    virtual void layOut (juce::Rectangle<int>) = 0;

    EditorLook look;
    TopBar bar;
    StatusLine status;

private:
    Shape windowShape;
    juce::SharedResourcePointer<EditorLook> fonts; ///< Of JUCE's own windows: menus and alerts.
    LocalTooltips tooltips { this, 600 };
};
} // namespace antinode
