#pragma once

namespace antinode
{
/** The reconstruction of a voltage from samples. Docs/Theory.md, section 6. */
enum class Reconstruction
{
    bandLimited,  ///< An audio interface: sum u_n K (t/T - n), K the windowed sinc of KaiserSinc.h.
    zeroOrderHold ///< An arbitrary waveform generator: u_n held until the next sample.
};

/** How a drive is played. A rate of 0 stands for the continuous waveform itself. */
struct Playback
{
    Reconstruction reconstruction = Reconstruction::bandLimited;
    double sampleRate = 0; ///< Hz, or 0.
};
} // namespace antinode
