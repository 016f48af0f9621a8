// The subcommands. They print, and return the exit code.
#pragma once

#include "Arguments.h"

namespace bolster::cli {

enum ExitCode { done = 0, otherFailure = 1, badInput = 2, notConverged = 3, partlyLooked = 3, partLeftOut = 3 };

/// `words` is what follows the name of the subcommand. They throw UsageError.
int check(std::span<const std::string> words);
int solve(std::span<const std::string> words);
int render(std::span<const std::string> words);
int bench(std::span<const std::string> words);
int convert(std::span<const std::string> words);
int dump(std::span<const std::string> words);
int explain(std::span<const std::string> words);
int exportPattern(std::span<const std::string> words);
int fitPattern(std::span<const std::string> words);
int flattenForm(std::span<const std::string> words);
int importDesign(std::span<const std::string> words);
int importPattern(std::span<const std::string> words);
int relieve(std::span<const std::string> words);
int sweep(std::span<const std::string> words);
int history(std::span<const std::string> words);
int verify(std::span<const std::string> words);
int thumbnail(std::span<const std::string> words);
int salvage(std::span<const std::string> words);

extern const char* const checkHelp;
extern const char* const solveHelp;
extern const char* const renderHelp;
extern const char* const benchHelp;
extern const char* const convertHelp;
extern const char* const dumpHelp;
extern const char* const explainHelp;
extern const char* const exportHelp;
extern const char* const fitPatternHelp;
extern const char* const flattenHelp;
extern const char* const importHelp;
extern const char* const importPatternHelp;
extern const char* const sweepHelp;
extern const char* const relieveHelp;
extern const char* const historyHelp;
extern const char* const verifyHelp;
extern const char* const thumbnailHelp;
extern const char* const salvageHelp;

} // namespace bolster::cli
