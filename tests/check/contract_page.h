// docs/contract.md as rows, for the tests that compare it with the tables of the code.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

namespace orris {

struct ContractRow {
  std::string section;  ///< "Programs"
  std::string name;     ///< as the contract's tables spell it
  std::string tier, state, code, test;
};

/// Every row of every table of the page.
std::vector<ContractRow> readContractPage();
std::vector<ContractRow> rowsOf(const std::string& section);

/// The names that a row's name stands for: "atan, atan2" is two, "colortex0" itself; brackets and
/// what is no name are dropped. A "*" or "<N>" is left as "*".
std::set<std::string> wordsOf(const std::string& name);
/// Those of all rows of a section.
std::set<std::string> wordsOfSection(const std::string& section);

/// Does one of `patterns` match? A "*" stands for any text.
bool matchesAny(const std::string& name, const std::set<std::string>& patterns);

/// The first column of a table of the contract.
std::vector<std::string> contractNames(const std::string& table);

}  // namespace orris
