// The rows of docs/contract.md, compiled in: what the game and this host know by name.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace orris {

struct ContractRow {
  std::string section;  ///< "Uniforms"
  std::string names;    ///< as written: "colortex0..colortex31"
  std::string state;    ///< "works", "constant", "not"
  std::string note;
};

/// Rows that are about the name; of a family ("composite3") that of its first member.
std::vector<const ContractRow*> contractRowsOf(std::string_view name);
const std::vector<ContractRow>& contractRows();

}  // namespace orris
