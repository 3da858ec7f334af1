// Reads block states, one a line, and prints what the block table knows of each: known, emission, opacity, cross, boxes
// in sixteenths. For minecraft_data.py.
#include <fmt/format.h>

#include <iostream>
#include <string>

#include <orris/world/blocks/block_facts.h>

int main() {
  const orris::BlockTable table;
  for (std::string line; std::getline(std::cin, line);) {
    const auto state = orris::parseBlockState(line);
    if (!state) return 1;
    const orris::BlockFacts facts = table.factsOf(*state);
    std::string boxes;
    for (const orris::ShapeBox& box : facts.boxes)
      boxes += fmt::format("{}[{},{},{},{},{},{}]", boxes.empty() ? "" : ",", box.from.x,
                           box.from.y, box.from.z, box.to.x, box.to.y, box.to.z);
    fmt::print("{{\"known\":{},\"emission\":{},\"opacity\":{},\"thin\":{},\"boxes\":[{}]}}\n",
               facts.known, facts.emission, facts.opacity, facts.air || facts.cross || facts.fluid,
               boxes);
  }
  return 0;
}
