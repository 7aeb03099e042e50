#include "CsoundBank.h"

#include <sstream>
#include <stdexcept>

namespace antinode::bench
{
namespace
{
std::string orchestra (double rate, int samples)
{
    std::ostringstream text;
    text << "sr = " << rate << "\nksmps = " << samples << "\nnchnls = 1\n0dbfs = 1\ninstr 1\nain = a(1)\nasum = 0\n";

    for (int k = 0; k < 64; ++k)
        text << "aone mode ain, " << 100 * (k + 1) << ", 50\nasum += aone\n";

    text << "out asum\nendin\n";
    return text.str();
}
} // namespace

CsoundBank::CsoundBank (double rate, int samples) : csound (csoundCreate (nullptr)), last (samples - 1)
{
    csoundCreateMessageBuffer (csound, 0); // else it tells standard error of itself
    csoundSetOption (csound, "--nosound");
    const auto isReady = csoundCompileOrc (csound, orchestra (rate, samples).c_str()) == CSOUND_SUCCESS
                         && csoundReadScore (csound, "i 1 0 36000\n") == CSOUND_SUCCESS
                         && csoundStart (csound) == CSOUND_SUCCESS;

    if (! isReady)
        throw std::runtime_error ("Csound does not start");
}

CsoundBank::~CsoundBank()
{
    csoundCleanup (csound);
    csoundDestroyMessageBuffer (csound);
    csoundDestroy (csound);
}

double CsoundBank::process()
{
    csoundPerformKsmps (csound);
    return csoundGetSpout (csound)[last];
}
} // namespace antinode::bench
