#include <antinode_documents/Inputs.h>
#include <antinode_documents/Library.h>
#include <antinode_documents/SkinThresholds.h>
#include <antinode_tracks/CandidateTracks.h>

#include <catch2/catch.hpp>

using namespace antinode;

TEST_CASE ("A choice of candidates has the voltages of a device with these ceramics alone", "[tracks]")
{
    const auto device = solveDevice (loadDevice ("phone-bare", {}), 40, false);
    auto waveforms = loadWaveforms ("phone-fingers", {});
    waveforms.tracks.resize (1);
    waveforms.tracks[0].events[0].level.value = 1e-8; // m: far below the limits
    TrackSettings settings;
    settings.threshold = findSkinThreshold ({});
    const CandidateTracks candidates (device, waveforms, settings);
    auto few = device;
    const std::vector<Eigen::Index> chosen { 9, 2, 14, 5 };
    few.participation = Eigen::MatrixXd (device.participation (Eigen::all, chosen));
    few.staticShare.resize (0, 0);
    few.ceramics.resize (chosen.size());
    const auto design = designTracks (few, waveforms, settings);
    const auto voltages = candidates.voltages (chosen);

    // What is played lies on these samples, and between them by interpolation.
    const auto factor = static_cast<Eigen::Index> (settings.sampleRate / candidates.sampleRate());
    CHECK (factor == 8);
    Eigen::MatrixXd played (voltages.rows(), voltages.cols());
    Eigen::Index first = 0;
    design.voltages.values.row (0).cwiseAbs().maxCoeff (&first);
    Eigen::Index largest = 0;
    voltages.col (0).cwiseAbs().maxCoeff (&largest);
    first = (first + factor / 2) / factor - largest;

    for (Eigen::Index n = 0; n < voltages.rows(); ++n)
        played.row (n) = design.voltages.values.col ((n + first) * factor).transpose();

    CHECK ((played - voltages).norm() < 1e-9 * voltages.norm());
}
