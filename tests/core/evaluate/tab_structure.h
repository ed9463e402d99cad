#pragma once

#include "core/skeleton/skeleton.h"

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace espalier::test {

/// Reads an MTG laid out in columns as PlantScan3D does.
inline Skeleton readTabStructure(const std::filesystem::path& path) {
  std::ifstream file(path);
  Skeleton plant;
  std::vector<NodeId> last; // by column
  std::string line;
  while (std::getline(file, line) && !line.starts_with("ENTITY-CODE")) {
  }
  while (std::getline(file, line)) {
    const std::size_t column = line.find_first_not_of('\t');
    if (column == std::string::npos || line.starts_with("/P")) continue;
    const std::size_t entity = line.find('N', column);
    if (entity == std::string::npos) continue;
    Node node;
    std::istringstream values(line.substr(entity + 1));
    values >> node.position.x() >> node.position.y() >> node.position.z() >> node.radius;
    const char type = line[entity - 1];
    if (type == '<') node.parent = last.at(column);
    if (type == '+') {
      node.parent = last.at(line[column] == '^' ? column : column - 1);
      node.edge = EdgeType::branching;
    }
    last.resize(column);
    last.push_back(plant.add(node));
  }
  return plant;
}

} // namespace espalier::test
