#pragma once

#include <csound/csound.h>

namespace antinode::bench
{
/** 64 opcodes `mode` of Csound in parallel, in an instrument that sounds all the time. */
class CsoundBank
{
public:
    /** @param samples  of a block, Csound's ksmps
        @throws std::runtime_error  where Csound does not start */
    CsoundBank (double rate, int samples);
    ~CsoundBank();
    CsoundBank (const CsoundBank&) = delete;
    CsoundBank& operator= (const CsoundBank&) = delete;

    /** Performs a block: its input is 1. @return  the last sample */
    double process();

private:
    CSOUND* csound;
    int last;
};
} // namespace antinode::bench
