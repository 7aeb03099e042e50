#pragma once

// Included before JUCE's VST3 wrapper and nowhere else (CMake/Plugins.cmake): its controller then derives from the one
// below. Docs/Design/plugins.md

#if JucePlugin_Build_VST3

#include <public.sdk/source/vst/vsteditcontroller.h>

#include <cmath>

namespace Steinberg::Vst
{
/** A controller whose parameters keep their values where a host sets what is no number. Steinberg's own keeps that and
   gives it back. */
class FiniteEditController : public EditController
{
public:
    tresult PLUGIN_API setParamNormalized (ParamID parameter, ParamValue value) override
    {
        return std::isfinite (value) ? EditController::setParamNormalized (parameter, value) : kInvalidArgument;
    }
};
} // namespace Steinberg::Vst

#define EditController FiniteEditController

#endif
