// The first check after an edit: what an editor shows while the whole check goes on.
#pragma once

#include <memory>
#include <set>
#include <string>

#include <orris/validate/validate_pack.h>

namespace orris {

/// What compiling the first programs reports that read one of the files `changed`: at most eight, of each name
/// one. For an editor, before the whole check of the same files. Returns their stages ("/world0/final.fsh").
std::set<std::string> compileEdited(const std::shared_ptr<const FileSource>& files,
                                    const std::set<std::string>& changed,
                                    const ValidateOptions& options, Checker& checker,
                                    ProblemList& problems);

}  // namespace orris
