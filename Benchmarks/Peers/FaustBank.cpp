#include "FaustBank.h"

#define FAUSTFLOAT double // of the samples that are passed in and out
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <faust/dsp/dsp.h>
#include <faust/gui/UI.h>
#include <faust/gui/meta.h>

// What Faust's compiler wrote gets the instruction set that its users would ask for; it is not ours to warn about.
#pragma GCC push_options
#pragma GCC target("arch=haswell")
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wunused-parameter"
#pragma GCC diagnostic ignored "-Wpedantic"
#pragma GCC diagnostic ignored "-Woverloaded-virtual"
#include "FaustModes.h"
#pragma GCC diagnostic pop
#pragma GCC pop_options

namespace antinode::bench
{
struct FaustBank::Code
{
    FaustModes modes;
};

FaustBank::FaustBank (double rate) : code (std::make_unique<Code>())
{
    code->modes.init (static_cast<int> (rate));
}

FaustBank::~FaustBank() = default;

void FaustBank::process (double* in, double* out, int samples)
{
    code->modes.compute (samples, &in, &out);
}
} // namespace antinode::bench
