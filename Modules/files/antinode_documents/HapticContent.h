#pragma once

#include <antinode_tracks/Waveforms.h>

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace antinode
{
/** What haptic content wants one place to feel. The amplitude of an event is its intensity: a share of the level that a
    track has. */
struct HapticContent
{
    std::vector<TrackEvent> events;    ///< Their levels are not set.
    std::vector<std::string> warnings; ///< What was assumed or left out, a sentence each.
};

/** How long a transient lasts, s, as in MPEG's reference software. */
inline constexpr double transientDuration = 0.022;

/** Nothing begins, ends or jumps in less time than this, s. */
inline constexpr double shortestEdge = 0.002;

/** What is weaker is none. */
inline constexpr double leastIntensity = 1e-6;

/** The frequency that a sharpness is played with, Hz: 65 at 0, 300 at 1, a straight line in between, as in MPEG's
    reference software. @param sharpness  clamped to 0 to 1 [any] Docs/Manual/waveforms.md */
double hapticFrequency (double sharpness);

/** A transient from its begin on. [any] */
std::vector<VibrationPoint> transientPoints (double intensity, double sharpness);

/** Adds a vibration as an event, of its largest amplitude; nothing where that is below leastIntensity. @param start  s
 * [any] */
void addVibration (HapticContent&, double start, std::vector<VibrationPoint>);

/** A file of waveforms as a document, antinode.waveforms/1. Haptic content, recognised by what is in the file, becomes
    one: AHAP, HJIF and Android's VibrationEffect, as XML or as timings and amplitudes in JSON. It has one track, under
   a medium finger, with a list of events, without place and level. Other JSON stays as it is.
    @param source  how errors name it
    @throws InputError  for what cannot be read, content without any vibration
    [worker] Docs/FileFormats.md. */
nlohmann::json waveformsDocument (std::string_view bytes, const std::string& source);

/** A document of waveforms with what its files of haptic content say in their place: "events": "tap.ahap". What is no
    such document stays as it is.
    @param folder  where the names of files begin
    @throws InputError  as waveformsDocument, and for a file that cannot be read
    [worker] */
nlohmann::json withHapticFiles (nlohmann::json document, const std::filesystem::path& folder);
} // namespace antinode
