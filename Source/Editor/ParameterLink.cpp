#include "ParameterLink.h"

#include <utility>

namespace antinode
{
ParameterLink::ParameterLink (juce::RangedAudioParameter& parameterToShow, std::function<void (float)> show)
    : parameter (parameterToShow), showValue (std::move (show))
{
}

void ParameterLink::refresh()
{
    const auto now = parameter.getValue();

    if (std::exchange (shown, now) != now)
        showValue (parameter.convertFrom0to1 (now));
}

void ParameterLink::set (float value)
{
    if (const auto wanted = parameter.convertTo0to1 (value); wanted != parameter.getValue())
        parameter.setValueNotifyingHost (wanted);
}

void ParameterLink::setAsGesture (float value)
{
    beginGesture();
    set (value);
    endGesture();
}
} // namespace antinode
