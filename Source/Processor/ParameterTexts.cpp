#include "ParameterTexts.h"

#include <antinode_base/MessageText.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace antinode
{
namespace
{
constexpr double milli = 1e-3;

juce::String cut (const juce::String& text, int maximumLength)
{
    return maximumLength > 0 ? text.substring (0, maximumLength) : text;
}

/** Enough decimals that small numbers keep their digits, none that say nothing. */
juce::String numberText (double value, int decimals)
{
    auto text = juce::String (value, decimals);
    return text.containsChar ('.') ? text.trimCharactersAtEnd ("0").trimCharactersAtEnd (".") : text;
}

/** What a text says; 0 where it says no number, "nan" included. */
double numberIn (const juce::String& text)
{
    const auto number = text.getDoubleValue();
    return std::isnan (number) ? 0.0 : number;
}

/** From where to where the surface goes, mm; both 0 if there is none. */
std::pair<double, double> axisExtent (const ModalModel* model, SurfaceAxis axis)
{
    if (model == nullptr)
        return { 0, 0 };

    const auto& surface = model->surface;
    return axis == SurfaceAxis::x ? std::pair (surface.xMinimum / milli, surface.xMaximum / milli)
                                  : std::pair (surface.yMinimum / milli, surface.yMaximum / milli);
}
} // namespace

NumberTexts unitTexts (const char* unit, int decimals, float minimum, const char* wordBelow)
{
    const juce::String word (wordBelow), suffix (juce::String::fromUTF8 (unit));

    return { [=] (float value, int maximumLength)
             {
                 if (value < minimum && word.isNotEmpty())
                     return cut (word, maximumLength);

                 const auto number = numberText (static_cast<double> (value), decimals);
                 return cut (suffix.isEmpty() ? number : number + " " + suffix, maximumLength);
             },
             [=] (const juce::String& text)
             { return word.isNotEmpty() && text.trim() == word ? -1e9F : static_cast<float> (numberIn (text)); } };
}

NumberTexts placeTexts (const std::function<std::shared_ptr<const ModalModel>()>& model, SurfaceAxis axis)
{
    return { [=] (float percent, int maximumLength)
             {
                 const auto [from, to] = axisExtent (model().get(), axis);
                 const auto millimetres = from + (to - from) * static_cast<double> (percent) / 100;
                 return cut (to > from ? numberText (millimetres, 3) + " mm"
                                       : numberText (static_cast<double> (percent), 3) + " %",
                             maximumLength);
             },
             [=] (const juce::String& text)
             {
                 const auto [from, to] = axisExtent (model().get(), axis);
                 const auto isPercent = text.containsChar ('%') || ! (to > from);
                 const auto value = numberIn (text);
                 return static_cast<float> (
                     std::clamp (isPercent ? value : 100 * (value - from) / (to - from), 0.0, 100.0));
             } };
}

IntegerTexts countTexts (const char* wordForNone)
{
    const juce::String word (wordForNone);
    return { [=] (int value, int maximumLength)
             { return cut (value == 0 ? word : juce::String (value), maximumLength); },
             [] (const juce::String& text) { return std::max (0, text.getIntValue()); } };
}

IntegerTexts wordTexts (const std::vector<juce::String>& words)
{
    return { [=] (int value, int maximumLength)
             {
                 const auto index = std::clamp (value, 0, static_cast<int> (words.size()) - 1);
                 return cut (words[static_cast<std::size_t> (index)], maximumLength);
             },
             [=] (const juce::String& text)
             {
                 const auto found = std::find (words.begin(), words.end(), text.trim());
                 return found == words.end() ? text.getIntValue() : static_cast<int> (found - words.begin());
             } };
}

FlagTexts flagTexts (const char* on, const char* off)
{
    const juce::String yes (on), no (off);
    return { [=] (bool value, int maximumLength) { return cut (value ? yes : no, maximumLength); },
             [=] (const juce::String& text)
             {
                 const auto trimmed = text.trim().toLowerCase();
                 return trimmed == yes || trimmed == "on" || trimmed == "yes" || trimmed == "true"
                        || trimmed.getFloatValue() >= 0.5F;
             } };
}
} // namespace antinode
