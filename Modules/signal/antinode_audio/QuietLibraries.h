#pragma once

namespace antinode
{
/** Silences what ALSA and JACK print without a sound card or server; the program reports it itself. [message thread] */
void silenceAudioLibraries();
} // namespace antinode
