#include <antinode_documents/Inputs.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_render/RenderedFocus.h>
#include <antinode_text/WaveFile.h>

#include <nlohmann/json.hpp>

#include <catch2/catch.hpp>

#include <cstdlib>
#include <fstream>

using namespace antinode;

namespace
{
const std::vector<int> rates { 44100, 48000, 88200, 96000, 176400, 192000, 384000, 768000 };
const auto* const referenceFile = ANTINODE_TEST_DATA "/Render/fingerprints.json";

const ModalModel& demonstrator()
{
    static const auto model = solveStructure (loadDevice ("staple", {}));
    return model;
}

RenderedFocus renderAt (int rate, int blockSize)
{
    RenderOptions options;
    options.playback = { Reconstruction::bandLimited, static_cast<double> (rate) };
    options.blockSize = blockSize;
    options.duration = 0.03;
    return renderFocus (demonstrator(), designFocus (demonstrator(), loadFocus ("demonstrator", {}), options.playback),
                        options);
}

/** What must stay the same from version to version: energies and what the plate did. */
nlohmann::ordered_json makeFingerprint (const RenderedFocus& focus)
{
    nlohmann::ordered_json print;
    const Eigen::VectorXd energies = focus.render.voltages.rowwise().squaredNorm() / focus.render.sampleRate;
    print["voltage_energies_V2s"] = std::vector<double> (energies.begin(), energies.end());
    print["probe_energy"] = focus.render.probeVelocities.squaredNorm() / focus.render.sampleRate;
    print["focus_velocities"] =
        std::vector<double> (focus.render.focusVelocities.begin(), focus.render.focusVelocities.begin() + 16);
    print["peak_voltage_V"] = focus.render.voltages.cwiseAbs().maxCoeff();
    return print;
}

void checkNumbers (const nlohmann::json& reached, const nlohmann::json& reference, double margin)
{
    if (! reference.is_array())
    {
        CHECK (reached.get<double>() == Approx (reference.get<double>()).epsilon (1e-8).margin (margin));
        return;
    }

    REQUIRE (reached.size() == reference.size());

    for (std::size_t i = 0; i < reference.size(); ++i)
        checkNumbers (reached[i], reference[i], margin);
}
} // namespace

TEST_CASE ("Renders at 44.1 to 768 kHz keep their fingerprints to 1e-8", "[render]")
{
    std::ifstream stream (referenceFile);
    const auto reference = nlohmann::json::parse (stream);

    for (const auto rate : rates)
    {
        INFO ("rate " << rate);
        const nlohmann::json print = makeFingerprint (renderAt (rate, 512));

        for (const auto& [key, value] : reference.at (std::to_string (rate)).items())
            checkNumbers (print.at (key), value, 1e-14);
    }
}

TEST_CASE ("Renders are the same to the bit for block sizes 1, 7, 64, 512, 8193 and from run to run", "[render]")
{
    for (const auto rate : { 44100, 192000, 768000 })
    {
        const auto first = renderAt (rate, 512);
        const auto bytes = encodeWave (first.render.voltages, 150, rate);

        for (const auto blockSize : { 1, 7, 64, 512, 8193 })
        {
            const auto again = renderAt (rate, blockSize);
            CHECK (again.render.voltages == first.render.voltages);
            CHECK (again.render.probeVelocities == first.render.probeVelocities);
            CHECK (again.render.modalVelocities == first.render.modalVelocities);
            CHECK (encodeWave (again.render.voltages, 150, rate) == bytes);
        }
    }
}

TEST_CASE ("The demonstrator keeps its scores at every rate", "[render]")
{
    for (const auto rate : rates)
    {
        const auto focus = renderAt (rate, 512);
        INFO ("rate " << rate << " error " << focus.truncatedScore.fieldError);
        CHECK (focus.truncatedScore.vScore >= 0.9999);
        CHECK (focus.truncatedScore.fieldError <= 0.005);
        CHECK ((focus.render.voltages.cwiseAbs().rowwise().maxCoeff().array()
                <= focus.design.program.voltageLimits.array())
                   .all());
    }
}

TEST_CASE ("Write the fingerprints anew (after a change that is meant to change them)", "[.][update]")
{
    // Names of tests choose hidden ones too: reference values are not written by accident.
    if (std::getenv ("ANTINODE_WRITE_FINGERPRINTS") == nullptr)
    {
        WARN ("set ANTINODE_WRITE_FINGERPRINTS to write " << referenceFile);
        return;
    }

    nlohmann::ordered_json all;

    for (const auto rate : rates)
        all[std::to_string (rate)] = makeFingerprint (renderAt (rate, 512));

    std::ofstream stream (referenceFile);
    stream << all.dump (1) << "\n";
    CHECK (stream.good());
}
