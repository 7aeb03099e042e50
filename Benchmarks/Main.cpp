#include <benchmark/benchmark.h>

#include <string>
#include <vector>

/** Google Benchmark's own, with --json for --benchmark_format=json. */
int main (int count, char** arguments)
{
    std::string json = "--benchmark_format=json";
    std::vector<char*> words (arguments, arguments + count);

    for (auto& word : words)
        if (std::string (word) == "--json")
            word = json.data();

    benchmark::Initialize (&count, words.data());

    if (benchmark::ReportUnrecognizedArguments (count, words.data()))
        return 1;

    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
