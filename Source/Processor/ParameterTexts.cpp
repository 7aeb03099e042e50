#include "ParameterTexts.h"

#include <antinode_base/MessageText.h>
#include <antinode_base/TypedNumber.h>

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

std::optional<double> numberIn (const juce::String& text, std::initializer_list<std::string_view> units)
{
    return typedNumber (text.toStdString(), units);
}

std::optional<int> wholeNumberIn (const juce::String& text)
{
    constexpr double most = 1e9;
    const auto number = numberIn (text, {});
    return number && *number == std::round (*number) && std::abs (*number) <= most
               ? std::optional (static_cast<int> (*number))
               : std::nullopt;
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
             [=] (const juce::String& text) -> std::optional<float>
             {
                 if (word.isNotEmpty() && text.trim().equalsIgnoreCase (word))
                     return -1e9F;

                 return numberIn (text, { unit });
             } };
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
             [=] (const juce::String& text) -> std::optional<float>
             {
                 const auto [from, to] = axisExtent (model().get(), axis);
                 const auto isPercent = text.containsChar ('%') || ! (to > from);
                 const auto value = numberIn (text, { isPercent ? "%" : "mm" });

                 if (! value)
                     return {};

                 return static_cast<float> (
                     std::clamp (isPercent ? *value : 100 * (*value - from) / (to - from), 0.0, 100.0));
             } };
}

IntegerTexts countTexts (const char* wordForNone)
{
    const juce::String word (wordForNone);
    return { [=] (int value, int maximumLength)
             { return cut (value == 0 ? word : juce::String (value), maximumLength); },
             [=] (const juce::String& text) -> std::optional<int>
             { return text.trim().equalsIgnoreCase (word) ? 0 : wholeNumberIn (text); } };
}

IntegerTexts wordTexts (const std::vector<juce::String>& words)
{
    return { [=] (int value, int maximumLength)
             {
                 const auto index = std::clamp (value, 0, static_cast<int> (words.size()) - 1);
                 return cut (words[static_cast<std::size_t> (index)], maximumLength);
             },
             [=] (const juce::String& text) -> std::optional<int>
             {
                 const auto found =
                     std::find_if (words.begin(), words.end(),
                                   [&] (const auto& word) { return word.equalsIgnoreCase (text.trim()); });
                 return found == words.end() ? wholeNumberIn (text) : static_cast<int> (found - words.begin());
             } };
}

FlagTexts flagTexts (const char* on, const char* off)
{
    const juce::String yes (on), no (off);
    return { [=] (bool value, int maximumLength) { return cut (value ? yes : no, maximumLength); },
             [=] (const juce::String& text) -> std::optional<bool>
             {
                 const auto trimmed = text.trim();
                 const auto isOneOf = [&] (std::initializer_list<juce::String> words)
                 {
                     return std::any_of (words.begin(), words.end(),
                                         [&] (const auto& word) { return trimmed.equalsIgnoreCase (word); });
                 };

                 if (isOneOf ({ yes, "on", "yes", "true" }))
                     return true;

                 if (isOneOf ({ no, "off", "no", "false" }))
                     return false;

                 const auto number = numberIn (text, {});
                 return number ? std::optional (*number >= 0.5) : std::nullopt;
             } };
}
} // namespace antinode
