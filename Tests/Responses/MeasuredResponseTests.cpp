#include "Support/ErrorText.h"

#include <antinode_responses/CsvHeading.h>
#include <antinode_responses/MeasurementReader.h>
#include <antinode_responses/UniversalFile.h>
#include <antinode_responses/UniversalResponses.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <numbers>

using namespace antinode;

namespace
{
using Complex = std::complex<double>;

/** Two responses of velocity per volt on lines that six digits do not tell. */
FrequencyResponses exampleResponses (DriveQuantity drive)
{
    FrequencyResponses responses;
    responses.drive = drive;
    responses.frequencies.resize (3);
    responses.frequencies << 100.0 / 3, 200.0 / 3, 100;
    responses.points.resize (2, 2);
    responses.points << 0.01, 0.02, -0.03, 0.04;
    responses.references = { { "C1", {} }, { "C2", {} } };

    if (drive == DriveQuantity::force)
        responses.references = { { "1", 0 }, { "2", 1 } };

    responses.values.assign (2, Eigen::MatrixXcd::Random (3, 2));
    responses.values[1] *= 2;
    return responses;
}

Measurement merged (const std::vector<std::pair<std::string, std::string>>& files,
                    const MeasurementOptions& options = {}, CsvForm form = CsvForm::byHeadings)
{
    std::vector<MeasurementFile> read;

    for (const auto& [name, text] : files)
        read.push_back (decodeMeasurement (text, name, form));

    return mergedResponses (read, options);
}

double unitScale (std::string_view unit)
{
    const auto found = responseUnit (unit);
    return found ? found->factor : 0;
}

MeasuredResponse simpleResponse (const std::string& point, const std::string& reference, ResponseUnit unit)
{
    return { "file",
             point,
             reference,
             {},
             unit,
             sharedFrequencies (Eigen::Vector2d (50, 100), {}),
             Eigen::Vector2cd (1, Complex (0, 2)),
             0 };
}
} // namespace

TEST_CASE ("Units of motion per drive are read as people write them", "[files][measurement]")
{
    constexpr double gravity = 9.80665;
    CHECK (unitScale ("(m/s^2)/N") == 1);
    CHECK (unitScale ("mm/s/V") == 1e-3);
    CHECK (unitScale ("(1/N)*(m/s\xc2\xb2)") == 1);
    CHECK (unitScale ("\xc2\xb5m/V") == 1e-6);
    CHECK (unitScale ("um V^-1") == 1e-6);
    CHECK (unitScale ("m/(s mV)") == Approx (1e3));
    CHECK (unitScale ("g/N") == Approx (gravity));
    CHECK (unitScale ("1/kg") == 1);
    CHECK (unitScale ("m/s2") == 1);
    CHECK (responseUnit ("1/kg")->quantity == ResponseQuantity::acceleration);
    CHECK (responseUnit ("1/kg")->drive == DriveQuantity::force);
    CHECK (responseUnit ("nm/V")->quantity == ResponseQuantity::displacement);
    CHECK_FALSE (responseUnit ("m/s")->drive);

    for (const auto* const other : { "", "NONE", "Pa", "m/s^3", "V", "m^2", "m/", "((((((((((((m", "g^2/Hz", "N/m" })
        CHECK_FALSE ((responseUnit (other) && unitScale (other) != 1));

    for (const auto* const inGravity :
         { "g's/N", "G/N", "gn/N", "gee/N", "g rms/N", "Grms/N", "1000 mg/N", "980.665 Gal/N" })
        CHECK (unitScale (inGravity) == Approx (gravity));

    constexpr double pound = 4.4482216152605, inch = 0.0254;
    CHECK (unitScale ("g's/lb") == Approx (gravity / pound));
    CHECK (unitScale ("(g)/(lbs)") == Approx (gravity / pound));
    CHECK (unitScale ("in/sec^2/LBF") == Approx (inch / pound));
    CHECK (unitScale ("ft/s^2") == Approx (0.3048));
    CHECK (unitScale ("ips/V") == Approx (inch));
    CHECK (unitScale ("mils/ozf") == Approx (1e-3 * inch * 16 / pound));
    CHECK (unitScale ("um/kgf") == Approx (1e-6 / gravity));
    CHECK (unitScale ("m/kp") == Approx (1 / gravity));
    CHECK (unitScale ("MM/S/V") == Approx (1e-3));
    CHECK (unitScale ("cm/dyn") == Approx (1e3));
    CHECK (unitScale ("micron/kN") == Approx (1e-9));
    CHECK (unitScale ("(m/s^2)/Newton") == 1);
    CHECK (unitScale ("millimeters per second per volt") == Approx (1e-3));
    CHECK (unitScale ("m\xc2\xb7s\xe2\x81\xbb\xc2\xb2/N") == 1);
    CHECK (unitScale ("m/s\xb2") == 1);                      // Latin-1
    CHECK (unitScale ("(g)(mN)") == Approx (1e3 * gravity)); // Side by side they are a ratio.
    CHECK (unitScale ("1e-6 m/s/N") == Approx (1e-6));
    CHECK (driveUnit ("lbs")->factor == Approx (pound));
    CHECK (driveUnit ("MN")->factor == Approx (1e6));
    CHECK_FALSE (responseUnit ("Nm"));
    CHECK (driveUnit ("mV")->factor == 1e-3);
    CHECK (driveUnit ("N")->drive == DriveQuantity::force);
    CHECK_FALSE (driveUnit ("m"));
}

TEST_CASE ("Units stand in headings in many forms, and a label that is not known is named", "[files][measurement]")
{
    for (const auto* const heading :
         { "Real (g's/N)", "Real [g/N]", "real_P3_C1 g/N", "Acceleration [g] / Force [N] real", "P1 g's per N imag",
           "Magnitude (dB re 1 g/N)", "Accel (g) Force (N)", "Mag, g / N" })
    {
        const auto unit = unitInText (heading);
        REQUIRE (unit);
        CHECK (unit->factor == Approx (9.80665));
        CHECK (unit->drive == DriveQuantity::force);
    }

    CHECK (csvHeading ("P3 (m/s^2)/N real").point == "p3");
    const auto table = merged ({ { "a.csv", "f,Real (furlong/N),Imag (furlong/N)\n1,1,0\n2,1,0\n" } });
    REQUIRE_FALSE (table.remarks.empty());
    CHECK (table.remarks[0].starts_with ("a.csv: 'furlong/N' is not a known unit"));

    UniversalFunction function;
    function.functionType = 4;
    function.values = Eigen::VectorXcd::Ones (8);
    function.step = 1;
    function.ordinate = { 12, {}, "Acceleration", "g's" };
    function.denominator = { 13, {}, "Force", "lb" };
    const auto read = measurementFromUniversal ({ function }, "a.uff");
    CHECK (read.responses[0].unit.factor == Approx (9.80665 / 4.4482216));
    CHECK (read.remarks.empty());
    function.denominator.unit = "stone";
    const auto other = measurementFromUniversal ({ function }, "a.uff");
    REQUIRE (other.remarks.size() == 1);
    CHECK (other.remarks[0].starts_with ("a.uff: 'stone' is not a known unit"));
}

TEST_CASE ("Displacement times i omega and acceleration over i omega are the same velocity", "[files][measurement]")
{
    const Complex jw (0, 2 * std::numbers::pi * 50);
    const auto valueIn = [] (ResponseQuantity quantity)
    {
        const MeasurementFile file { { simpleResponse ("1", "1", { quantity, 1e-3, DriveQuantity::voltage }) },
                                     {},
                                     {} };
        return mergedResponses ({ file }, {}).responses.values[0](0, 0);
    };
    CHECK (std::abs (valueIn (ResponseQuantity::velocity) - 1e-3) < 1e-18);
    CHECK (std::abs (valueIn (ResponseQuantity::displacement) - 1e-3 * jw) < 1e-15);
    CHECK (std::abs (valueIn (ResponseQuantity::acceleration) - 1e-3 / jw) < 1e-18);
}

TEST_CASE ("Responses written as a universal file come back to the bit", "[files][measurement]")
{
    for (const auto drive : { DriveQuantity::voltage, DriveQuantity::force })
    {
        const auto responses = exampleResponses (drive);
        const auto file = encodeUniversalFile (responseSets (responses));
        const auto read = mergedResponses ({ decodeMeasurement (file, "a.uff", CsvForm::byHeadings) }, {});
        CHECK (read.remarks.empty());
        CHECK (read.hasPlaces);
        CHECK (read.responses.drive == drive);
        CHECK (read.responses.frequencies == responses.frequencies);
        CHECK (read.responses.points == responses.points);
        CHECK (read.responses.values == responses.values);
        REQUIRE (read.responses.references.size() == 2);
        CHECK (read.responses.references[1].name == responses.references[1].name);
        CHECK (read.responses.references[1].point == responses.references[1].point);
    }
}

TEST_CASE ("Drivers keep the order of their channels, and names that are too long for their field stay apart",
           "[files][measurement]")
{
    auto responses = exampleResponses (DriveQuantity::voltage);
    responses.references = { { "C2", {} }, { "C1", {} } };
    const auto swapped = mergedResponses ({ measurementFromUniversal (responseSets (responses), "a") }, {});
    CHECK (swapped.responses.references[0].name == "C2");
    CHECK (swapped.responses.values == responses.values);

    responses.references = { { "ceramic on the left", {} }, { "ceramic on the right", {} } };
    const auto renamed = mergedResponses ({ measurementFromUniversal (responseSets (responses), "a") }, {});
    CHECK (renamed.responses.references[1].name == "D2");
    CHECK (renamed.responses.values == responses.values);
}

TEST_CASE ("A direction against an axis turns the sign, and factors of units divide lengths", "[files][measurement]")
{
    auto sets = responseSets (exampleResponses (DriveQuantity::force));
    const auto before = mergedResponses ({ measurementFromUniversal (sets, "a") }, {});

    for (auto& set : sets)
        if (auto* const function = std::get_if<UniversalFunction> (&set))
        {
            function->response.direction = -3;
            function->ordinate.unit = "NONE"; // Then the codes of quantities count, in the file's units.
            function->denominator.unit = "NONE";
        }

    std::get<UniversalUnits> (sets[0]).length = 1e3;
    std::get<UniversalUnits> (sets[0]).force = 10;
    const auto after = mergedResponses ({ measurementFromUniversal (sets, "a") }, {});
    CHECK ((after.responses.points * 1e3 - before.responses.points).cwiseAbs().maxCoeff() < 1e-15);
    CHECK ((after.responses.values[0] * -100 - before.responses.values[0]).cwiseAbs().maxCoeff() < 1e-12);
}

TEST_CASE ("A table's headings name parts, points, references and units", "[files][measurement]")
{
    const auto one = merged ({ { "a.csv", "frequency_Hz,P2 C1 real (mm/s)/V,P2 C1 imag,P1 C1 real (mm/s)/V,P1 C1 imag\n"
                                          "10,1,2,3,4\n20,5,6,7,8\n" } });
    CHECK (one.pointNames == std::vector<std::string> { "p1", "p2" });
    CHECK (one.responses.references[0].name == "c1");
    CHECK (std::abs (one.responses.values[0](1, 0) - Complex (7e-3, 8e-3)) < 1e-15);

    const auto other =
        merged ({ { "b.csv", "# accelerometer, (m/s^2)/N\nf [Hz];magnitude point 3 [dB];phase point 3 [deg]\n"
                             "10,0;20,0;90\n20,0;0,0;-90\n" } });
    CHECK (other.responses.drive == DriveQuantity::force);
    CHECK (other.pointNames == std::vector<std::string> { "3" });
    CHECK (std::abs (other.responses.values[0](0, 0) - Complex (10 / (2 * std::numbers::pi * 10), 0)) < 1e-12);
    CHECK (std::abs (other.responses.values[0](1, 0) + Complex (1 / (2 * std::numbers::pi * 20), 0)) < 1e-12);
}

TEST_CASE ("Tables without headings hold pairs of real and imaginary part, or what the user says",
           "[files][measurement]")
{
    const auto text = "0 9 9\n1,5 3,0 4,0\n3 0 0,5\n";
    const auto measured = merged ({ { "a.txt", text } });
    CHECK (measured.responses.frequencies == Eigen::Vector2d (1.5, 3)); // At 0 Hz nothing moves.
    CHECK (measured.responses.values[0](0, 0) == Complex (3, 4));
    CHECK (measured.remarks.size() == 2); // Of drive and places.
    CHECK (! measured.responses.isQuantityStated);
    const auto polar = merged ({ { "a.txt", text } }, {}, CsvForm::magnitudeRadians);
    CHECK (std::abs (polar.responses.values[0](0, 0) - std::polar (3.0, 4.0)) < 1e-15);
}

TEST_CASE ("Files of one response each are points, files of several with the same points are references",
           "[files][measurement]")
{
    const auto points = merged ({ { "a.csv", "1,1,0\n2,1,0\n" }, { "b.csv", "1,2,0\n2,2,0\n" } });
    CHECK (points.responses.points.rows() == 2);
    CHECK (points.responses.references.size() == 1);
    CHECK (points.responses.values[0](0, 1) == 2.0);

    const auto references = merged ({ { "a.csv", "1,1,0,2,0\n2,1,0,2,0\n" }, { "b.csv", "1,3,0,4,0\n2,3,0,4,0\n" } });
    CHECK (references.responses.points.rows() == 2);
    CHECK (references.responses.references.size() == 2);
    CHECK (references.responses.values[1](0, 1) == 4.0);

    const auto named =
        merged ({ { "point10_driver1.csv", "1,1,0\n2,1,0\n" }, { "point9_driver1.csv", "1,2,0\n2,2,0\n" } });
    CHECK (named.pointNames == std::vector<std::string> { "point9", "point10" });
}

TEST_CASE ("For a roving hammer, points and references are exchanged", "[files][measurement]")
{
    auto responses = exampleResponses (DriveQuantity::force);
    responses.points.conservativeResize (1, 2);
    responses.references = { { "1", 0 }, { "2", {} }, { "3", {} } };
    responses.values.assign (3, Eigen::MatrixXcd::Random (3, 1));
    auto sets = responseSets (responses);
    UniversalLabel node = 0;

    for (auto& set : sets)
        if (auto* const function = std::get_if<UniversalFunction> (&set))
            function->reference = { "NONE", ++node, 3 };

    const auto measured = mergedResponses ({ measurementFromUniversal (sets, "a") }, {});
    CHECK (measured.responses.points.rows() == 3);
    REQUIRE (measured.responses.references.size() == 1);
    CHECK (measured.responses.references[0].point == 0);
}

TEST_CASE ("Inconsistent files are refused with a reason", "[files][measurement]")
{
    const auto refusal = [] (const std::vector<std::pair<std::string, std::string>>& files)
    { return errorText ([&] { merged (files); }); };
    CHECK (refusal ({ { "a.csv", "1,1,0\n2,1,0\n" }, { "b.csv", "1,2,0\n3,2,0\n" } })
           == "b.csv: has different frequencies from 'a.csv'; allowed: responses with the same lines; identify the "
              "files separately");
    CHECK (refusal ({ { "a.csv", "1,1,0\n2,1\n" } })
           == "a.csv: line 2: has 2 cells; allowed: 3 as in the first line of numbers");
    CHECK (refusal ({ { "a.csv", "f,real,imag\n1,1,x\n" } }) == "a.csv: line 2: has 'x'; allowed: numbers");
    CHECK (refusal ({ { "a.csv", "f,real,real\n1,1,0\n" } })
           == "a.csv: column 2 has no column with the other part of its response");
    CHECK (refusal ({ { "a.csv", "nothing" } }) == "a.csv: has no line of numbers");
    CHECK (refusal ({ { "a.csv", "2,1,0\n1,1,0\n3,1,0\n" } })
           == "frequency responses: have frequencies that do not ascend");
}

TEST_CASE ("Recordings over time are not taken for responses", "[files][measurement]")
{
    const auto refusal = [] (const std::string& text) { return errorText ([&] { merged ({ { "hit.csv", text } }); }); };
    std::string bare;

    for (int i = 0; i < 100; ++i)
        bare += std::to_string (i * 5e-4) + ",0.5,1.5\n";

    CHECK (
        refusal (bare)
        == "hit.csv: has frequencies up to 0.0495 Hz every 0.0005 Hz, which look like times; allowed: lines at "
           "least 0.0025 Hz apart, and 0.1 Hz where none is above 20 Hz; the heading of a column of times is 'time'");
    CHECK (refusal ("time (s),force (N),1 z (m/s^2)\n" + bare)
           == "hit.csv: has a force over time 'force (N)'; allowed: frequency responses, or impulse responses, which "
              "'frf' computes from recordings of force and motion");

    UniversalFunction function;
    function.functionType = 1;
    function.isEven = true;
    function.step = 1e-3;
    function.values = Eigen::VectorXcd::Ones (8);
    function.ordinate.quantity = 12;
    auto force = function;
    force.ordinate.quantity = 13;
    CHECK (errorText (
               [&] {
                   measurementFromUniversal ({ function, force }, "hit.uff");
               })
           == "hit.uff: has time records of a force; allowed: frequency responses, or impulse responses, which 'frf' "
              "computes from recordings of force and motion");
    CHECK (measurementFromUniversal ({ function }, "response.uff").responses.size() == 1);
}

TEST_CASE ("A message on one file names it once", "[files][measurement]")
{
    CHECK (errorText (
               []
               {
                   auto file =
                       measurementFromCsv ("f,P1 (m/s)/V real,P1 imag,P2 (m/s)/N real,P2 imag\n1,1,0,1,0\n2,1,0,1,0\n",
                                           "a.csv", CsvForm::byHeadings);
                   mergedResponses ({ file }, {});
               })
           == "a.csv: is excited by a different quantity than an earlier response of it; allowed: responses to "
              "voltages only or to forces only");
}

TEST_CASE ("An impulse response that is cut off has its residues times 1 - e^(sT) on the lines of its record",
           "[files][measurement]")
{
    constexpr double rate = 1000, duration = 2, decay = 1.5, frequency = 40;
    const Complex pole (-decay, 2 * std::numbers::pi * frequency);
    std::string text = "time_s,velocity\n";

    for (int n = 0; n < rate * duration; ++n)
        text += std::to_string (n / rate) + "," + std::to_string (std::exp (pole * (n / rate)).real()) + "\n";

    const auto measured = merged ({ { "a.csv", text } });
    CHECK (measured.recordLength == Approx (duration));
    const Complex z (0, 2 * std::numbers::pi * 40.5 / rate), ratio = std::exp (pole / rate),
                                                             cut = 1.0 - std::exp (pole * duration);
    const auto line = 80; // 40.5 Hz: lines begin at 0.5 Hz.
    const auto sum =
        0.5 / rate
        * (cut / (1.0 - ratio * std::exp (-z)) + std::conj (cut) / (1.0 - std::conj (ratio) * std::exp (-z)));
    CHECK (measured.responses.frequencies[line] == Approx (40.5));
    CHECK (std::abs (measured.responses.values[0](line, 0) - sum) < 1e-6); // Six digits of the samples.
}

TEST_CASE ("Responses of which nothing was measured are no universal file", "[files]")
{
    FrequencyResponses responses;
    responses.frequencies = Eigen::Vector2d (10, 20);
    responses.references = { { "C1", {} } };
    responses.points = Eigen::RowVector2d (0, 0);
    responses.values = { Eigen::MatrixXcd::Constant (2, 1, std::numeric_limits<double>::quiet_NaN()) };
    CHECK_THROWS_WITH (responseSets (responses), Catch::Contains ("nothing can be written"));

    responses.values[0](1, 0) = 1;
    CHECK_NOTHROW (responseSets (responses));
}
