#include "Support/ErrorText.h"

#include <antinode_responses/CsvResponses.h>
#include <antinode_text/CsvTable.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace antinode;

namespace
{
using Complex = std::complex<double>;

/** One response in (m/s^2)/N, 3+4i and 1-2i at 10 and 20 Hz, in a table of another form each. */
void requireExample (const std::string& text, const Complex& first = { 3, 4 }, const Complex& second = { 1, -2 })
{
    INFO (text);
    const auto measured = mergedResponses ({ measurementFromCsv (text, "a.csv", CsvForm::byHeadings) }, {});
    const auto& responses = measured.responses;
    REQUIRE (responses.frequencies == Eigen::Vector2d (10, 20));
    CHECK (responses.drive == DriveQuantity::force);
    const auto velocityPer = [] (double frequency) { return 1.0 / Complex (0, 2 * std::numbers::pi * frequency); };
    CHECK (std::abs (responses.values[0](0, 0) - first * velocityPer (10)) < 1e-9);
    CHECK (std::abs (responses.values[0](1, 0) - second * velocityPer (20)) < 1e-9);
}

const std::string head = "Frequency (Hz),Real ((m/s^2)/N),Imag ((m/s^2)/N)\n";
} // namespace

TEST_CASE ("Tables of many programs hold the same response", "[files][measurement]")
{
    requireExample (head + "10,3,4\n20,1,-2\n");
    requireExample (head + "10,3,4\n20,1,-2\nEND\n");
    requireExample (head + "10,3,4\n20,1,-2\n\nMean of 5 averages, done\n");
    requireExample ("\xef\xbb\xbf" + head + "10,3,4\r\n20,1,-2\r\n");
    requireExample (head + "20,1,-2\n10,3,4\n");
    requireExample (head + "0,Inf,0\n10,3,4\n20,1,-2\n");
    requireExample ("Frequency (Hz),Real ((m/s^2)/N),Imag ((m/s^2)/N),\n10,3,4,\n20,1,-2,\n");
    requireExample (head + "10,3,4,,\n20,1,-2,,\n");
    requireExample ("f (Hz);Re (m/s\xb2/N);Im (m/s\xb2/N)\n10,0;3,0;4,0\n20,0;1,0;-2,0\n");
    requireExample (
        "Units: Ratio\r\nFrequency\t Real\t Imaginary\r\n\r\nHz\t(m/s\xb2)(N)\t \r\n10\t3\t4\r\n20\t1\t-2\r\n");
    requireExample ("Index,Frequency (kHz),Real ((m/s^2)/N),Imag\n1,0.01,3,4\n2,0.02,1,-2\n");

    // UTF-16 with its mark, as spreadsheets write "Unicode text".
    std::string wide = "\xff\xfe";

    for (const auto character : head + "10,3,4\n20,1,-2\n")
        wide += { character, '\0' };

    requireExample (wide);
}

TEST_CASE ("Complex cells are read in the ways of many programs", "[files][measurement]")
{
    for (const auto* const cells : { "10,3+4i\n20,1-2i\n", "10,3 + 4j\n20,1 - 2j\n", "10,3+4*i\n20,1-2*i\n",
                                     "10,(3+4j)\n20,(1-2j)\n", "10,\"(3,4)\"\n20,\"(1,-2)\"\n", "10,(3,4)\n20,(1,-2)\n",
                                     "10,3+i4\n20,1-j2\n", "10,3.0e+0+4.0E+00i\n20,1-2e0i\n" })
        requireExample (std::string ("Frequency (Hz),P1 ((m/s^2)/N)\n") + cells);

    requireExample ("Frequency (Hz);P1 ((m/s^2)/N)\n10;3,0+4,0i\n20;-2,0i\n", { 3, 4 }, { 0, -2 });
    const auto table = readCsvTable ("f,H\n1,5\n2,1+i\n3,-i\n", "a.csv");
    CHECK (table.headings == std::vector<std::string> { "f", "H real", "H imag" });
    CHECK (table.numbers.col (1) == Eigen::Vector3d (5, 1, 0));
    CHECK (table.numbers.col (2) == Eigen::Vector3d (0, 1, -1));
}

TEST_CASE ("Magnitudes have many names, and decibels refer to a unit", "[files][measurement]")
{
    const Complex first = std::polar (2.0, std::numbers::pi / 6), second = std::polar (0.5, -std::numbers::pi / 2);

    for (const auto* const names :
         { "Magnitude ((m/s^2)/N),Phase (\xc2\xb0)", "|Z| ((m/s^2)/N),Phase (\xb0)", "Modulus ((m/s^2)/N),Angle (deg)",
           "Amp ((m/s^2)/N),Phase [deg]", "|Z| ((m/s^2)/N),arg(Z) [deg]", "|H21| ((m/s^2)/N),arg(H21) [deg]" })
        requireExample (std::string ("Frequency (Hz),") + names + "\n10,2,30\n20,0.5,-90\n", first, second);

    for (const auto* const names : { "Magnitude (dB re 1 m/s^2/N),Phase (deg)", "Gain (dB) (m/s^2)/N,Phase (deg)",
                                     "|H| dB ref 1 (m/s^2)/N,Phase (deg)" })
        requireExample (std::string ("Frequency (Hz),") + names + "\n10,6.020599913,30\n20,-6.020599913,-90\n", first,
                        second);

    requireExample (
        "Frequency (Hz),Level (dB re 1e-6 m/s^2/N),Phase (deg)\n10,126.020599913,30\n20,113.979400087,-90\n", first,
        second);
}

TEST_CASE ("Frequencies may stand before every response", "[files][measurement]")
{
    std::string told = "Frequency (Hz),Real,Imag,Frequency (Hz),Real,Imag\n", bare;

    for (int i = 1; i < 9; ++i)
        bare += std::to_string (10 * i) + ",1,2," + std::to_string (10 * i) + ",3,4\n";

    for (const auto& text : { told + bare, bare })
    {
        const auto responses =
            mergedResponses ({ measurementFromCsv (text, "a.csv", CsvForm::byHeadings) }, {}).responses;
        REQUIRE (responses.points.rows() == 2);
        CHECK (responses.values[0](5, 1) == Complex (3, 4));
    }
}

TEST_CASE ("A file of LabVIEW tells its units and whether it has times", "[files][measurement]")
{
    const std::string labView =
        "LabVIEW Measurement\t\nSeparator\tTab\nX_Columns\tOne\nDate\t2026/11/28\nTime\t12:00:00.5\n"
        "***End_of_Header***\t\n\t\nChannels\t2\t\t\nSamples\t2\t2\t\nY_Unit_Label\tg\tN\t\n"
        "X_Dimension\tTime\tTime\t\nX0\t0.0E+0\t0.0E+0\t\nDelta_X\t0.001\t0.001\t\n"
        "***End_of_Header***\t\t\t\nX_Value\tAcceleration\tHammer\tComment\n";
    const auto table = readCsvTable (labView + "0.000\t0.5\t10\t\n0.001\t0.25\t5\n", "a.lvm");
    CHECK (table.headings == std::vector<std::string> { "Time X_Value", "Acceleration (g)", "Hammer (N)" });
    CHECK (table.numbers.rows() == 2);
}

TEST_CASE ("Times of the day, with a date or over midnight, and rounded times have one interval", "[files][hammer]")
{
    const auto intervalOf = [] (const std::string& text)
    { return samplingInterval (readCsvTable (text, "a.csv").numbers.col (0), "a.csv"); };
    CHECK (intervalOf ("t,x\n23:59:59.50,1\n23:59:59.75,2\n00:00:00.00,3\n") == Approx (0.25));
    CHECK (intervalOf ("t;x\n2026-11-28 12:00:00,5;1\n2026-11-28 12:00:01,0;2\n") == Approx (0.5));
    CHECK (intervalOf ("Date,Time,x\n11/28/2026,11:59:59 AM,1\n11/28/2026,12:00:00 PM,2\n") == Approx (1));

    // 5120 Hz to four digits: steps of 1e-4 and 2e-4. The line through them is known to 1e-4 / N^1.5.
    const Eigen::VectorXd exact = Eigen::VectorXd::LinSpaced (2001, 0, 2000) / 5120;
    const Eigen::VectorXd rounded = (exact.array() * 1e4).round() / 1e4;
    CHECK (samplingInterval (rounded, "a.csv") == Approx (1.0 / 5120).epsilon (1e-5));

    Eigen::VectorXd gap = rounded; // Ten samples are missing.
    gap.tail (1000).array() += 10.0 / 5120;
    CHECK (errorText ([&] { samplingInterval (gap, "a.csv"); })
           == "a.csv: has unevenly spaced times; allowed: samples at a constant rate");
}

TEST_CASE ("A damaged table is refused by its cause", "[files][measurement]")
{
    const auto refusal = [] (const std::string& text) { return errorText ([&] { readCsvTable (text, "a.csv"); }); };
    CHECK (refusal (head + "10,3,4\nnoise,1,2\n30,1,2\n") == "a.csv: line 3: has 'noise'; allowed: numbers");
    CHECK (refusal (head + "10,3,4\n2O,1,2\n") == "a.csv: line 3: has '2O'; allowed: numbers");
    CHECK (refusal (head + "10,3,4\n20,1\n")
           == "a.csv: line 3: has 2 cells; allowed: 3 as in the first line of numbers");
    CHECK (refusal (std::string ("a\0b", 3)) == "a.csv: is not a text table");
}
