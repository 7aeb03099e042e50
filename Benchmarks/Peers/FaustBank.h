#pragma once

#include <memory>

namespace antinode::bench
{
/** Faust's own modal filters, 64 in parallel (modes.dsp), as its compiler writes them. */
class FaustBank
{
public:
    explicit FaustBank (double rate);
    ~FaustBank();
    FaustBank (const FaustBank&) = delete;
    FaustBank& operator= (const FaustBank&) = delete;

    void process (double* in, double* out, int samples);

private:
    struct Code;
    std::unique_ptr<Code> code;
};
} // namespace antinode::bench
