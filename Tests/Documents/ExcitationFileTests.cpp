#include "Support/ErrorText.h"

#include <antinode_documents/ExcitationFile.h>
#include <antinode_text/JsonText.h>

#include <catch2/catch.hpp>

using namespace antinode;

namespace
{
ExcitationSheet makeSheet (ExcitationSignal signal)
{
    ExcitationSettings settings;
    settings.signal = signal;
    settings.sampleRate = 8000;
    settings.lowestFrequency = 50;
    settings.highestFrequency = 2000;
    settings.resolution = 5;
    settings.sweepDuration = 0.5;
    settings.levels = Eigen::Vector2d (10, 20);
    ExcitationSheet sheet { "beam", { "left", "right" }, Eigen::Vector2d (100, 50), 150, {} };
    sheet.excitation = makeExcitation (settings, sheet.voltageLimits);
    return sheet;
}
} // namespace

TEST_CASE ("A sheet that was written and read gives the same excitation")
{
    const auto signal = GENERATE (ExcitationSignal::multisine, ExcitationSignal::sweep, ExcitationSignal::noise);
    const auto sheet = makeSheet (signal);
    const auto document = parseJson (excitationToJson (sheet, "signal.wav").dump(), "sheet.json");
    CHECK (readSignalFileName (document, "sheet.json") == "signal.wav");
    const auto read = readExcitation (document, "sheet.json", sheet.excitation.signal);
    CHECK (read.device == "beam");
    CHECK (read.ceramics == sheet.ceramics);
    CHECK (read.voltageLimits == sheet.voltageLimits);
    CHECK (read.fullScaleVoltage == 150);
    CHECK (read.excitation.settings.levels == sheet.excitation.settings.levels);
    CHECK (read.excitation.lines == sheet.excitation.lines);
    CHECK (read.excitation.block == sheet.excitation.block);
    CHECK (read.excitation.runLength == sheet.excitation.runLength);
    CHECK (read.excitation.crestFactor == sheet.excitation.crestFactor);
}

TEST_CASE ("Sheets that are wrong say where")
{
    const auto sheet = makeSheet (ExcitationSignal::multisine);
    auto document = parseJson (excitationToJson (sheet, "signal.wav").dump(), "sheet.json");
    const auto error = [&]
    { return errorText ([&] { readExcitation (document, "sheet.json", sheet.excitation.signal); }); };

    SECTION ("another resolution than that of the signal")
    {
        document["resolution_Hz"] = 4;
        CHECK_THAT (error(), Catch::Contains ("does not fit these settings"));
    }

    SECTION ("a level beyond the limit")
    {
        document["ceramics"][1]["level_V"] = 51;
        CHECK_THAT (error(), Catch::Contains ("level of ceramic 2: is 51 V"));
    }

    SECTION ("a key nobody knows")
    {
        document["odd_line"] = true;
        CHECK_THAT (error(), Catch::Contains ("did you mean 'odd_lines'"));
    }

    SECTION ("a signal elsewhere")
    {
        document["signal_file"] = "../signal.wav";
        CHECK_THAT (errorText ([&] { readSignalFileName (document, "sheet.json"); }),
                    Catch::Contains ("is not a plain file name; allowed: a file in the folder of the sheet"));
    }
}
