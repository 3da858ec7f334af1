#include <orris/check/pack/pack_checks.h>

#include <orris/check/frame/frame_checks.h>
#include <orris/check/frame/texture_checks.h>
#include <orris/check/ids/id_checks.h>
#include <orris/check/interface/declaration_checks.h>
#include <orris/check/options/language_checks.h>
#include <orris/check/options/option_checks.h>
#include <orris/check/options/screen_checks.h>
#include <orris/check/pack/condition_names.h>
#include <orris/check/pack/decimal_conditions.h>
#include <orris/check/pack/directive_checks.h>
#include <orris/check/pack/expression_checks.h>
#include <orris/check/pack/file_name_checks.h>
#include <orris/check/pack/include_checks.h>
#include <orris/check/pack/open_comments.h>
#include <orris/check/pack/property_checks.h>
#include <orris/check/pack/slip_checks.h>
#include <orris/check/pack/version_checks.h>

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
    checkTexturesUsed,
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
