#include "Support/ErrorText.h"
#include "Support/RunProgram.h"

#include <antinode_responses/MatlabFile.h>
#include <antinode_responses/MatlabResponses.h>

#include <matio.h>

#include <catch2/catch.hpp>

#include <array>
#include <numeric>

using namespace antinode;
using namespace antinode::test;

namespace
{
struct Sizes
{
    std::vector<std::size_t> frequencies, responses;
};

/** A file as libmatio writes it: f, H counting 0, 1, 2 ... with its negative as imaginary part, unit. */
std::string writtenBy (mat_ft version, matio_compression compression, Sizes sizes, const char* abscissa = "f")
{
    const TemporaryFolder folder;
    const auto path = (folder.path() / "a.mat").string();
    auto* const file = Mat_CreateVer (path.c_str(), nullptr, version);
    const auto write = [&] (matvar_t* variable)
    {
        Mat_VarWrite (file, variable, compression);
        Mat_VarFree (variable);
    };
    std::vector<double> frequencies (sizes.frequencies[0] * sizes.frequencies[1]);
    std::iota (frequencies.begin(), frequencies.end(), 1);
    std::vector<double> real (
        std::accumulate (sizes.responses.begin(), sizes.responses.end(), std::size_t (1), std::multiplies<>())),
        imaginary;
    std::iota (real.begin(), real.end(), 0);

    for (const auto number : real)
        imaginary.push_back (-number);

    mat_complex_split_t parts { real.data(), imaginary.data() };
    std::string unit = "(mm/s)/V";
    std::array<std::size_t, 2> unitSizes { 1, unit.size() };
    write (Mat_VarCreate ("unit", MAT_C_CHAR, MAT_T_UTF8, 2, unitSizes.data(), unit.data(), 0));
    write (Mat_VarCreate (abscissa, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, sizes.frequencies.data(), frequencies.data(), 0));
    write (Mat_VarCreate ("H", MAT_C_DOUBLE, MAT_T_DOUBLE, static_cast<int> (sizes.responses.size()),
                          sizes.responses.data(), &parts, MAT_F_COMPLEX));
    Mat_Close (file);
    return readContent (path);
}

Measurement measurementFromBytes (const std::string& bytes)
{
    return mergedResponses ({ measurementFromMatlab (readMatlabFile (bytes, "a.mat"), "a.mat") }, {});
}
} // namespace

TEST_CASE ("MATLAB files are read as libmatio writes them, compressed or not", "[files][matlab]")
{
    for (const auto compression : { MAT_COMPRESSION_NONE, MAT_COMPRESSION_ZLIB })
    {
        const auto variables =
            readMatlabFile (writtenBy (MAT_FT_MAT5, compression, { { 5, 1 }, { 5, 3, 2 } }), "a.mat");
        REQUIRE (variables.size() == 3);
        CHECK (variables[0].text == "(mm/s)/V");
        CHECK (variables[1].name == "f");
        CHECK (variables[1].real == std::vector<double> { 1, 2, 3, 4, 5 });
        CHECK (variables[2].sizes == std::vector<std::size_t> { 5, 3, 2 });
        CHECK (variables[2].real[29] == 29);
        CHECK (variables[2].imaginary[29] == -29);
    }
}

TEST_CASE ("The numbers of lines, points and references assign the dimensions of an array", "[files][matlab]")
{
    // Line f (of 5), point p (of 3) and driver i (of 2) of an array whose entries count up.
    struct Case
    {
        Sizes sizes;
        double line, point, reference;
    };

    for (const auto& each :
         { Case { { { 5, 1 }, { 5, 3, 2 } }, 1, 5, 15 }, Case { { { 1, 5 }, { 3, 5, 2 } }, 3, 1, 15 },
           Case { { { 5, 1 }, { 2, 3, 5 } }, 6, 2, 1 }, Case { { { 5, 1 }, { 3, 2, 5 } }, 6, 1, 3 } })
    {
        const auto measured = measurementFromBytes (writtenBy (MAT_FT_MAT5, MAT_COMPRESSION_ZLIB, each.sizes));
        REQUIRE (measured.responses.values.size() == 2);
        REQUIRE (measured.responses.points.rows() == 3);
        const auto expected = 1e-3 * (4 * each.line + 2 * each.point + each.reference);
        CHECK (measured.responses.values[1](4, 2).real() == Approx (expected));
        CHECK (measured.responses.values[1](4, 2).imag() == Approx (-expected));
    }

    const auto renamed = writtenBy (MAT_FT_MAT5, MAT_COMPRESSION_NONE, { { 5, 1 }, { 5, 3, 2 } }, "axis");
    CHECK (measurementFromBytes (renamed).responses.frequencies[4] == 5);
    const auto single = measurementFromBytes (writtenBy (MAT_FT_MAT5, MAT_COMPRESSION_NONE, { { 5, 1 }, { 5, 1 } }));
    CHECK (single.responses.values.size() == 1);
    CHECK (single.responses.points.rows() == 1);
}

TEST_CASE ("MATLAB files of other versions and damaged ones are refused in a sentence", "[files][matlab]")
{
    const auto refusal = [] (const std::string& bytes) { return errorText ([&] { measurementFromBytes (bytes); }); };
    const auto good = writtenBy (MAT_FT_MAT5, MAT_COMPRESSION_ZLIB, { { 5, 1 }, { 5, 3 } });
    CHECK (refusal (writtenBy (MAT_FT_MAT73, MAT_COMPRESSION_NONE, { { 5, 1 }, { 5, 3 } }))
           == "a.mat: is a MATLAB file of version 7.3; allowed: versions 5 to 7 (save it with '-v7')");
    CHECK (refusal (good.substr (0, 100)) == "a.mat: is not a MATLAB file of version 5 to 7");
    CHECK (refusal (good.substr (0, good.size() - 9)) == "a.mat: is damaged: an element is longer than the file");
    CHECK (refusal (good.substr (0, 128)).starts_with ("a.mat: has no vector of frequencies; allowed: one named 'f'"));
    CHECK (refusal (writtenBy (MAT_FT_MAT5, MAT_COMPRESSION_NONE, { { 4, 1 }, { 5, 3 } }))
           == "a.mat: has 0 complex arrays with a size of 4, the number of frequencies; allowed: one, or the name "
              "'H' or 'FRF'; "
              "it has 'unit' (1 x 8), 'f' (4 x 1), 'H' (5 x 3, complex)");

    for (std::size_t i = 128; i < good.size(); ++i) // No byte that is wrong does more than lead to a sentence.
    {
        auto bad = good;
        bad[i] = static_cast<char> (bad[i] ^ 0x55);
        refusal (bad);
    }
}

TEST_CASE ("Objects of MATLAB are named, with what to save instead", "[files][measurement]")
{
    const auto element = [] (std::uint32_t type, const std::string& data)
    {
        const auto size = static_cast<std::uint32_t> (data.size());
        return std::string (reinterpret_cast<const char*> (&type), 4)
               + std::string (reinterpret_cast<const char*> (&size), 4) + data
               + std::string ((8 - data.size() % 8) % 8, '\0');
    };
    const auto head = std::string ("MATLAB 5.0 MAT-file") + std::string (105, ' ') + std::string ("\0\1IM", 4);
    const std::string opaque { "\x11\0\0\0\0\0\0\0", 8 }, object { "\x3\0\0\0\0\0\0\0", 8 },
        sizes { "\1\0\0\0\1\0\0\0", 8 };
    const auto refusal = [&] (const std::string& matrix)
    { return errorText ([&] { measurementFromBytes (head + element (14, matrix)); }); };

    for (const auto& matrix : { element (6, opaque) + element (1, "G1") + element (1, "MCOS") + element (1, "frd"),
                                element (6, object) + element (5, sizes) + element (1, "G1") + element (1, "frd") })
    {
        const auto text = refusal (matrix);
        CHECK (text.find ("it has 'G1' (an object of class frd)") != text.npos);
        CHECK (
            text.find (
                "save arrays, of an frd or idfrd by G = chgFreqUnit (G1, 'Hz'); f = G.Frequency; H = G.ResponseData; "
                "save ('responses.mat', 'f', 'H', '-v7')")
            != text.npos);
    }
}
