#include "check/pack_checks.h"

#include "check/condition_names.h"
#include "check/declaration_checks.h"
#include "check/directive_checks.h"
#include "check/expression_checks.h"
#include "check/file_name_checks.h"
#include "check/frame_checks.h"
#include "check/id_checks.h"
#include "check/include_checks.h"
#include "check/language_checks.h"
#include "check/open_comments.h"
#include "check/option_checks.h"
#include "check/property_checks.h"
#include "check/screen_checks.h"
#include "check/slip_checks.h"
#include "check/texture_checks.h"
#include "check/unused_functions.h"
#include "check/version_checks.h"

namespace orris {
namespace {

using FolderCheck = void (*)(const FolderInput&, Diagnostics&);
using WholePackCheck = void (*)(std::span<const ShaderPack>, Diagnostics&);

// In the order of the report.
constexpr FolderCheck kFolderChecks[] = {checkDeclarations, checkCustomUniforms, checkNewProperties,
                                         checkFrame};
constexpr WholePackCheck kWholePackChecks[] = {
    checkOptionLists,      //
    checkOptionUse,        //
    checkHiddenOptions,    //
    checkScreenLinks,      //
    checkSliders,          //
    checkProfiles,         //
    checkLanguageKeys,     //
    checkLanguageCover,    //
    checkUnusedIncludes,   //
    checkNestedComments,   //
    checkConditionNames,   //
    checkFileNames,        //
    checkIdMaps,           //
    checkDirectiveNames,   //
    checkPropertiesTwice,  //
    checkStrayLines,       //
    checkDecimals,         //
    checkPropertyNames,    //
    checkMacroNames,       //
    checkTexturesUsed,     //
    checkUnusedFunctions,
};

}  // namespace

Diagnostics checkFolder(const FolderInput& input) {
  Diagnostics diagnostics;
  for (const FolderCheck check : kFolderChecks) check(input, diagnostics);
  return diagnostics;
}

Diagnostics checkWholePack(std::span<const ShaderPack> folders) {
  Diagnostics diagnostics;
  for (const WholePackCheck check : kWholePackChecks) check(folders, diagnostics);
  return diagnostics;
}

}  // namespace orris
