#pragma once

#include <antinode_documents/ExcitationFile.h>

#include <filesystem>

namespace antinode
{
/** All runs of an excitation, one after the other: (N_b + 1) x samples of full scale, ceramics, then the sync channel.
    @throws InputError  where they are too long to be kept [worker] */
Eigen::MatrixXd playedRuns (const ExcitationSheet&);

/** Writes excitation.wav, excitation.json and signal.wav.
    @throws InputError  as playedRuns, and when the folder cannot be written
    [worker] Docs/FileFormats.md. */
void writeExcitation (const std::filesystem::path& folder, const ExcitationSheet&);
} // namespace antinode
