#include "tests/core/io/qsm/qsm_samples.h"

namespace espalier::test {

std::string treeQsmTable() {
  return "radius (m)\tlength (m)\tstart_point\taxis_direction\tparent\textension\tbranch\t"
         "branch_order\tposition_in_branch\tmad\tSurfCov\tadded\tUnmodRadius (m)\n"
         "0.2\t2\t0\t0\t0\t0\t0\t1\t0\t2\t1\t0\t1\t0.001\t0.9\t0\t0.21\n"
         "0.1\t1\t0\t0\t2\t0\t0\t1\t1\t0\t1\t0\t2\t0.001\t0.9\t0\t0.1\n"
         "0.05\t1\t0\t0.2\t2\t0\t1\t0\t1\t4\t2\t1\t1\t0.001\t0.9\t0\t0.05\n"
         "0.04\t0.5\t0\t1.2\t2\t0\t1\t0\t3\t0\t2\t1\t2\t0.001\t0.9\t1\t0.04\n";
}

std::string treeQsmTableWithoutNames() {
  return "0.2\t2\t0\t0\t0\t0\t0\t1\t0\t2\t1\t0\t1\t0\t0.21\n"
         "0.1\t1\t0\t0\t2\t0\t0\t1\t1\t0\t1\t0\t2\t0\t0.1\n"
         "0.05\t1\t0\t0.2\t2\t0\t1\t0\t1\t4\t2\t1\t1\t0\t0.05\n"
         "0.04\t0.5\t0\t1.2\t2\t0\t1\t0\t3\t0\t2\t1\t2\t1\t0.04\n";
}

} // namespace espalier::test
