#include "Standalone.h"

int main (int argumentCount, char** arguments)
{
    return antinode::runStandalone (argumentCount, arguments);
}
