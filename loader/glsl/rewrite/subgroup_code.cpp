#include <orris/glsl/rewrite/subgroup_code.h>

#include <fmt/format.h>

#include <algorithm>

namespace orris {
namespace {

// A value of any type goes through four words.
struct SubgroupType {
  const char* name;
  const char* pack;    ///< of v into uvec4
  const char* unpack;  ///< of u, a uvec4
};
constexpr SubgroupType kSubgroupTypes[] = {
    {"float", "uvec4(floatBitsToUint(v), 0u, 0u, 0u)", "uintBitsToFloat(u.x)"},
    {"vec2", "uvec4(floatBitsToUint(v), 0u, 0u)", "uintBitsToFloat(u.xy)"},
    {"vec3", "uvec4(floatBitsToUint(v), 0u)", "uintBitsToFloat(u.xyz)"},
    {"vec4", "floatBitsToUint(v)", "uintBitsToFloat(u)"},
    {"int", "uvec4(uint(v), 0u, 0u, 0u)", "int(u.x)"},
    {"ivec2", "uvec4(uvec2(v), 0u, 0u)", "ivec2(u.xy)"},
    {"ivec3", "uvec4(uvec3(v), 0u)", "ivec3(u.xyz)"},
    {"ivec4", "uvec4(v)", "ivec4(u)"},
    {"uint", "uvec4(v, 0u, 0u, 0u)", "u.x"},
    {"uvec2", "uvec4(v, 0u, 0u)", "u.xy"},
    {"uvec3", "uvec4(v, 0u)", "u.xyz"},
    {"uvec4", "v", "u"},
    {"bool", "uvec4(uint(v), 0u, 0u, 0u)", "bool(u.x)"},
};

/// Of r, what was gathered, and x, what comes to it; `first` is what an exclusive scan begins with.
struct SubgroupArithmetic {
  const char* name;
  const char* combine;
  const char* first;
  bool floats;
};
constexpr SubgroupArithmetic kSubgroupArithmetic[] = {
    {"Add", "r + x", "0", true},     {"Mul", "r * x", "1", true},
    {"Min", "min(r, x)", "", true},  {"Max", "max(r, x)", "", true},
    {"And", "r & x", "-1", false},   {"Or", "r | x", "0", false},
    {"Xor", "r ^ x", "0", false},
};
/// Which lanes i an operation of lane `me` gathers.
struct SubgroupScan {
  const char* prefix;
  const char* parameter;
  const char* takes;
  bool exclusive;
};
constexpr SubgroupScan kSubgroupScans[] = {
    {"subgroup", "", "true", false},
    {"subgroupInclusive", "", "i <= gl_LocalInvocationIndex", false},
    {"subgroupExclusive", "", "i < gl_LocalInvocationIndex", true},
    {"subgroupClustered", ", uint n", "i / n == gl_LocalInvocationIndex / n", false},
};

/// The value of one other lane, given as an index in the work group.
struct SubgroupLane {
  const char* name;
  const char* parameter;
  const char* lane;
};
constexpr SubgroupLane kSubgroupLanes[] = {
    {"subgroupBroadcast", ", uint n", "orris_first() + n"},
    {"subgroupShuffle", ", uint n", "orris_first() + n"},
    {"subgroupShuffleXor", ", uint n", "gl_LocalInvocationIndex ^ n"},
    {"subgroupShuffleUp", ", uint n", "gl_LocalInvocationIndex - n"},
    {"subgroupShuffleDown", ", uint n", "gl_LocalInvocationIndex + n"},
    {"subgroupQuadBroadcast", ", uint n", "(gl_LocalInvocationIndex & ~3u) + n"},
    {"subgroupQuadSwapHorizontal", "", "gl_LocalInvocationIndex ^ 1u"},
    {"subgroupQuadSwapVertical", "", "gl_LocalInvocationIndex ^ 2u"},
    {"subgroupQuadSwapDiagonal", "", "gl_LocalInvocationIndex ^ 3u"},
    {"subgroupBroadcastFirst", "", "orris_elected()"},
};

/// Operations of one type, and what each is for an invocation alone.
struct SubgroupPlain {
  const char* name;
  const char* exchange;
  const char* alone;
};
constexpr SubgroupPlain kSubgroupPlain[] = {
    {"subgroupElect",
     "bool orris_subgroupElect() { orris_put(uvec4(0u)); bool r = orris_elected() == "
     "gl_LocalInvocationIndex; orris_take(); return r; } ",
     "bool orris_subgroupElect() { return true; } "},
    {"subgroupAll",
     "bool orris_subgroupAll(bool v) { return (orris_ballot(!v) == 0u); } ",
     "bool orris_subgroupAll(bool v) { return v; } "},
    {"subgroupAny", "bool orris_subgroupAny(bool v) { return orris_ballot(v) != 0u; } ",
     "bool orris_subgroupAny(bool v) { return v; } "},
    {"subgroupBallot",
     "uvec4 orris_subgroupBallot(bool v) { return uvec4(orris_ballot(v), 0u, 0u, 0u); } ",
     "uvec4 orris_subgroupBallot(bool v) { return uvec4(uint(v), 0u, 0u, 0u); } "},
    {"subgroupInverseBallot",
     "bool orris_subgroupInverseBallot(uvec4 v) { return (v.x >> orris_me() & 1u) != 0u; } ", ""},
    {"subgroupBallotBitExtract",
     "bool orris_subgroupBallotBitExtract(uvec4 v, uint n) { return (v.x >> n & 1u) != 0u; } ", ""},
    {"subgroupBallotBitCount",
     "uint orris_subgroupBallotBitCount(uvec4 v) { return uint(bitCount(v.x)); } ", ""},
    {"subgroupBallotInclusiveBitCount",
     "uint orris_subgroupBallotInclusiveBitCount(uvec4 v) { return uint(bitCount(v.x & "
     "(2u << orris_me()) - 1u)); } ",
     ""},
    {"subgroupBallotExclusiveBitCount",
     "uint orris_subgroupBallotExclusiveBitCount(uvec4 v) { return uint(bitCount(v.x & "
     "(1u << orris_me()) - 1u)); } ",
     ""},
    {"subgroupBallotFindLSB",
     "uint orris_subgroupBallotFindLSB(uvec4 v) { return uint(findLSB(v.x)); } ", ""},
    {"subgroupBallotFindMSB",
     "uint orris_subgroupBallotFindMSB(uvec4 v) { return uint(findMSB(v.x)); } ", ""},
    {"subgroupBarrier", "void orris_subgroupBarrier() { groupMemoryBarrier(); barrier(); } ",
     "void orris_subgroupBarrier() {} "},
    {"subgroupMemoryBarrier", "void orris_subgroupMemoryBarrier() { memoryBarrier(); } ", ""},
    {"subgroupMemoryBarrierBuffer",
     "void orris_subgroupMemoryBarrierBuffer() { memoryBarrierBuffer(); } ", ""},
    {"subgroupMemoryBarrierImage",
     "void orris_subgroupMemoryBarrierImage() { memoryBarrierImage(); } ", ""},
    {"subgroupMemoryBarrierShared",
     "void orris_subgroupMemoryBarrierShared() { groupMemoryBarrier(); } ", ""},
};

// Barriers: one after the values are written, one after they are read. Inside of loops not all
// invocations come equally often; so that of the work group counts who has come, as the end does.
constexpr const char* kExchange =
    "shared uvec4 orris_lanes[gl_WorkGroupSize.x * gl_WorkGroupSize.y * gl_WorkGroupSize.z]; "
    "shared uint orris_live[gl_WorkGroupSize.x * gl_WorkGroupSize.y * gl_WorkGroupSize.z]; "
    "shared uint orris_arrived; uint orris_due = 0u; "
    "const uint orris_count = gl_WorkGroupSize.x * gl_WorkGroupSize.y * gl_WorkGroupSize.z; "
    "void orris_begin() { orris_live[gl_LocalInvocationIndex] = 0u; "
    "if (gl_LocalInvocationIndex == 0u) orris_arrived = 0u; groupMemoryBarrier(); barrier(); } "
    "void orris_barrier() { groupMemoryBarrier(); atomicAdd(orris_arrived, 1u); "
    "orris_due += orris_count; "
    "do { barrier(); } while (atomicAdd(orris_arrived, 0u) < orris_due); groupMemoryBarrier(); } "
    "uint orris_first() { return gl_LocalInvocationIndex & ~31u; } "
    "uint orris_end() { return min(orris_first() + 32u, orris_count); } "
    "uint orris_me() { return gl_LocalInvocationIndex & 31u; } "
    "void orris_put(uvec4 v) { orris_lanes[gl_LocalInvocationIndex] = v; "
    "orris_live[gl_LocalInvocationIndex] = 1u; groupMemoryBarrier(); barrier(); } "
    "void orris_take() { groupMemoryBarrier(); barrier(); "
    "orris_live[gl_LocalInvocationIndex] = 0u; } "
    "uvec4 orris_at(uint i) { return orris_lanes[min(i, orris_count - 1u)]; } "
    "uint orris_elected() { uint r = orris_end(); for (uint i = orris_end(); i > orris_first(); --i) "
    "if (orris_live[i - 1u] != 0u) r = i - 1u; return r; } "
    "uint orris_ballot(bool v) { orris_put(uvec4(uint(v))); uint r = 0u; "
    "for (uint i = orris_first(); i < orris_end(); ++i) "
    "r |= (orris_live[i] & orris_lanes[i].x) << (i - orris_first()); orris_take(); return r; } ";
constexpr const char* kSubgroupAlone = "uint orris_me() { return 0u; } ";

struct SubgroupVariable {
  std::string_view name, exchange, alone;
};
constexpr SubgroupVariable kSubgroupVariables[] = {
    {"gl_SubgroupSize", "32u", "1u"},
    {"gl_SubgroupInvocationID", "(gl_LocalInvocationIndex & 31u)", "0u"},
    {"gl_SubgroupID", "(gl_LocalInvocationIndex / 32u)", "gl_LocalInvocationIndex"},
    {"gl_NumSubgroups",
     "((gl_WorkGroupSize.x * gl_WorkGroupSize.y * gl_WorkGroupSize.z + 31u) / 32u)",
     "(gl_WorkGroupSize.x * gl_WorkGroupSize.y * gl_WorkGroupSize.z)"},
    {"gl_SubgroupEqMask", "uvec4(1u << (gl_LocalInvocationIndex & 31u), 0u, 0u, 0u)",
     "uvec4(1u, 0u, 0u, 0u)"},
    {"gl_SubgroupGeMask", "uvec4(~0u << (gl_LocalInvocationIndex & 31u), 0u, 0u, 0u)",
     "uvec4(1u, 0u, 0u, 0u)"},
    {"gl_SubgroupGtMask", "uvec4(~1u << (gl_LocalInvocationIndex & 31u), 0u, 0u, 0u)",
     "uvec4(0u)"},
    {"gl_SubgroupLeMask", "uvec4(~(~1u << (gl_LocalInvocationIndex & 31u)), 0u, 0u, 0u)",
     "uvec4(1u, 0u, 0u, 0u)"},
    {"gl_SubgroupLtMask", "uvec4(~(~0u << (gl_LocalInvocationIndex & 31u)), 0u, 0u, 0u)",
     "uvec4(0u)"},
};

bool isFloatType(const SubgroupType& type) {
  return std::string_view(type.name).starts_with("float") || type.name[0] == 'v';
}

std::string gathered(const SubgroupArithmetic& op, const SubgroupScan& scan,
                     const SubgroupType& type, bool exchange) {
  const std::string start =
      scan.exclusive ? fmt::format("{0} r = {0}({1})", type.name, op.first)
                     : fmt::format("{0} r = v; bool any = false", type.name);
  const std::string head = fmt::format("{0} orris_{1}{2}({0} v{3}) {{ ", type.name, scan.prefix,
                                       op.name, scan.parameter);
  if (!exchange) {
    return head + (scan.exclusive ? start + "; return r; } " : std::string("return v; } "));
  }
  const std::string step =
      scan.exclusive ? fmt::format("r = {};", op.combine)
                     : fmt::format("r = any ? {} : x; any = true;", op.combine);
  return head + start +
         fmt::format("; orris_put({0}); for (uint i = orris_first(); i < orris_end(); ++i) "
                     "if (orris_live[i] != 0u && {1}) {{ uvec4 u = orris_lanes[i]; {2} x = {3}; "
                     "{4} }} orris_take(); return r; }} ",
                     type.pack, scan.takes, type.name, type.unpack, step);
}

std::string ofLane(const SubgroupLane& lane, const SubgroupType& type, bool exchange) {
  const std::string head =
      fmt::format("{0} orris_{1}({0} v{2}) {{ ", type.name, lane.name, lane.parameter);
  if (!exchange) return head + "return v; } ";
  return head + fmt::format("orris_put({}); uvec4 u = orris_at({}); orris_take(); return {}; }} ",
                            type.pack, lane.lane, type.unpack);
}

std::string allEqual(const SubgroupType& type, bool exchange) {
  const std::string head = fmt::format("bool orris_subgroupAllEqual({} v) {{ ", type.name);
  if (!exchange) return head + "return true; } ";
  return head + fmt::format(
                    "uvec4 own = {}; orris_put(own); bool r = true; for (uint i = orris_first(); "
                    "i < orris_end(); ++i) r = r && (orris_live[i] == 0u || orris_lanes[i] == own); "
                    "orris_take(); return r; }} ",
                    type.pack);
}

/// Definitions for every type; "" for another name.
std::string definitions(const std::string& name, bool exchange) {
  std::string result;
  for (const SubgroupType& type : kSubgroupTypes) {
    for (const SubgroupScan& scan : kSubgroupScans) {
      for (const SubgroupArithmetic& op : kSubgroupArithmetic) {
        const bool fits = (op.floats || !isFloatType(type)) && std::string_view(type.name) != "bool";
        const bool possible = !scan.exclusive || op.first[0] != '\0';
        if (fits && possible && name == std::string(scan.prefix) + op.name)
          result += gathered(op, scan, type, exchange);
      }
    }
    for (const SubgroupLane& lane : kSubgroupLanes)
      if (name == lane.name) result += ofLane(lane, type, exchange);
    if (name == "subgroupAllEqual") result += allEqual(type, exchange);
  }
  for (const SubgroupPlain& plain : kSubgroupPlain) {
    if (name == plain.name)
      result += exchange || plain.alone[0] == '\0' ? plain.exchange : plain.alone;
  }
  return result;
}

}  // namespace

bool isSubgroupFunction(std::string_view name) {
  return name.starts_with("subgroup") && !definitions(std::string(name), false).empty();
}

std::string subgroupFunctions(const std::set<std::string>& names, bool exchange) {
  std::string result = exchange ? kExchange : kSubgroupAlone;
  for (const std::string& name : names) result += definitions(name, exchange);
  return result;
}

std::string_view subgroupVariable(std::string_view name, bool exchange) {
  for (const SubgroupVariable& variable : kSubgroupVariables) {
    if (variable.name == name) return exchange ? variable.exchange : variable.alone;
  }
  return {};
}

}  // namespace orris
