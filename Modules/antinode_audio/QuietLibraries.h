#pragma once

namespace antinode
{
/** Lets ALSA and JACK keep what they print where there is no sound card or server: the program says it in a sentence. [message thread] */
void silenceAudioLibraries();
} // namespace antinode
