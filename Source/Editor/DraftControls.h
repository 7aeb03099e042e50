#pragma once

#include "DeviceDraft.h"
#include "EditorLook.h"

#include <juce_gui_basics/juce_gui_basics.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace antinode
{
/** A row of the device's panel: a name and what sets something of the drawn device. [message thread] */
class DraftRow : public juce::Component
{
public:
    static constexpr int height = 24;

    /** Shows what the device has. @return  whether it has such a thing: else there is no such row */
    virtual bool refresh() = 0;

    void resized() override;

protected:
    DraftRow (DeviceDraft&, const juce::String& name);

    /** To be called once it is made. */
    void addInput (juce::Component&);

    DeviceDraft& draft;
    juce::Label name;

private:
    juce::Component* input = nullptr;
};

/** A number, dragged or typed; the device follows while it is dragged. */
class DraftNumber final : public DraftRow
{
public:
    struct Kind
    {
        juce::String name, unit, tooltip;
        double least = 0, most = 1, middle = 0.5, step = 0;                ///< The middle of the bar.
        std::function<std::optional<double> (const nlohmann::json&)> read; ///< None: there is none.
        std::function<nlohmann::json (const nlohmann::json&, double)> write;
    };

    DraftNumber (DeviceDraft&, Kind);

    bool refresh() override;

    /** As if the user typed it. */
    void enter (double value) { bar.setValue (value, juce::sendNotificationSync); }

private:
    void change();

    Kind kind;
    juce::Slider bar { juce::Slider::LinearBar, juce::Slider::TextBoxRight };
    nlohmann::json heldDocument; ///< Before it was dragged.
    bool isDragged = false;
};

/** One of several words. */
class DraftChoice final : public DraftRow
{
public:
    struct Kind
    {
        juce::String name, tooltip;
        std::function<juce::StringArray (const nlohmann::json&)> words;
        std::function<std::optional<int> (const nlohmann::json&)> read; ///< -1: none of the words; none: there is none.
        std::function<void (int)> choose;
    };

    DraftChoice (DeviceDraft&, Kind);

    bool refresh() override;

    /** As if the user chose it. @param index  of the words */
    void enter (int index) { kind.choose (index); }

private:
    Kind kind;
    juce::ComboBox list;
    juce::StringArray shown;
};
/** Built-in materials as the words of a choice, with what scatters between samples. */
struct MaterialWords
{
    std::vector<std::string> names;
    juce::StringArray words;

    /** @param tables  of materials, one behind the other */
    template <typename... Tables>
    explicit MaterialWords (const Tables&... tables)
    {
        (add (tables), ...);
    }

    template <typename Table>
    void add (const Table& table)
    {
        for (const auto& entry : table)
        {
            names.emplace_back (entry.notes.name);
            words.add (fromUtf8 (std::string (entry.notes.name)) + "   "
                       + fromUtf8 (std::string (entry.notes.scatter)));
        }
    }

    /** -1: none of them. */
    int indexOf (const nlohmann::json& material) const;
};
} // namespace antinode
