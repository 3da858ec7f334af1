// What follows from a mistake that makes a compiler misread all that comes after it.
#pragma once

#include <memory>

#include <orris/report/problem_list.h>
#include <orris/validate/validate_pack.h>

namespace orris {

/// Checks the files of a pack again into a list of their own: what validatePath() reports of them.
using CheckAgain = void (*)(const std::shared_ptr<const FileSource>& files,
                            const ValidateOptions& options, Checker checker, ProblemList& problems);

/// Finds the mistakes of `problems` that carry a repair (a comment, conditional or brace without its
/// other end), checks the pack with these repaired, and makes all that is gone then consequences of
/// them (ProblemList::cause). Where the repair does not fit, the errors of all programs that read the file
/// are. A mistake that errors follow from is an error.
void findConsequences(const PackVerdict& verdict, const ValidateOptions& options,
                      const Checker& checker, CheckAgain check, ProblemList& problems);

}  // namespace orris
