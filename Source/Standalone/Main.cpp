#include "Standalone.h"

#include <antinode_base/System.h>

int main (int argumentCount, char** arguments)
{
    antinode::guardStandardStreams();
    antinode::keepFreedMemory();
    auto texts = antinode::programArguments (argumentCount, arguments);
    const auto pointers = antinode::argumentPointers (texts);
    return antinode::runStandalone (static_cast<int> (pointers.size()), pointers.data());
}
