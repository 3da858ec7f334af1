// Which options of a pack can be live (pack/options/live_options.h), and why the others cannot.
#pragma once

#include <map>
#include <string>

#include <orris/pack/shader_pack.h>

namespace orris {

/// By the name of an option why it cannot be a uniform, "" where it can: it is a number, no condition and
/// no properties file asks for it, and its programs have it in the code of functions alone, where GLSL
/// takes values that are no constants. Preprocesses all programs that read one of them.
std::map<std::string, std::string> liveOptions(const ShaderPack& pack);

}  // namespace orris
