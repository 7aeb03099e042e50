#include <antinode_base/MessageText.h>

#include <catch2/catch.hpp>

using namespace antinode;

TEST_CASE ("A typed number has a decimal point or comma, one sign, and a unit that is known", "[base]")
{
    CHECK (typedNumber ("0,5") == 0.5);
    CHECK (typedNumber (" 0.5 ") == 0.5);
    CHECK (typedNumber ("-3", { "mm" }) == -3);
    CHECK (typedNumber ("+3mm", { "mm" }) == 3);
    CHECK (typedNumber ("\xE2\x88\x92"
                        "3 mm",
                        { "mm" })
           == -3);
    CHECK (typedNumber ("1,5e3") == 1500);
    CHECK (typedNumber (",5") == 0.5);
    CHECK (typedNumber ("5 DB", { "dB" }) == 5);

    for (const auto* const micro : { "5 \xC2\xB5m", "5 \xCE\xBCm", "5um" })
        CHECK (typedNumber (micro, { "\xC2\xB5m" }) == 5);

    for (const auto* const text :
         { "",    " ",    "mm",       "5 m",   "5 mm mm", "5 5", "1,000.5", "1.000,5", "1,2,3", "nan",
           "inf", "-inf", "infinity", "1e999", "0x10",    "--1", "+-1",     "-+1",     "5-",    "a5" })
    {
        CAPTURE (text);
        CHECK_FALSE (typedNumber (text, { "mm" }));
    }
}
