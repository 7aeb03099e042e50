#pragma once

#include "HapticContent.h"

namespace antinode
{
/** Android's VibrationEffect as XML: waveforms, envelopes, primitives and predefined effects one after the other; what
    repeats is played once.
    @throws InputError  source, line, what is wrong, what is allowed
    [worker] android.os.vibrator.persistence.VibrationXmlParser */
HapticContent readVibrationEffect (std::string_view xml, const std::string& source);

/** The arguments of VibrationEffect.createWaveform as JSON: "timings" in ms, "amplitudes" of 0 to 255; where there are
    none, the vibrator is off and on in turns.
    @throws InputError  source, JSON pointer, what is wrong, what is allowed
    [worker] */
HapticContent readVibrationTimings (const nlohmann::json&, const std::string& source);
} // namespace antinode
