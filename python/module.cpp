#include "python/bindings.h"

namespace espalier::python {

std::string documented(const std::string& signature, const std::string& text) {
  return signature + "\n--\n\n" + text;
}

} // namespace espalier::python

PYBIND11_MODULE(espalier, module) {
  using namespace espalier::python;
  pybind11::options options;
  options.disable_function_signatures(); // documented() has them as Python reads them
  module.doc() =
      "From a laser scan of a plant to its skeleton.\n\n"
      "Scan holds points, Skeleton nodes, both as NumPy arrays; reconstruct() makes the one of "
      "the\n"
      "other by Options, decisions() says how sure that is, and evaluate() measures it against a\n"
      "reference. simulate() grows a plant whose truth is known. Lengths are in the unit of the\n"
      "scan. What cannot be done is an Error with the line that the program espalier has for it.";
  module.attr("__version__") = ESPALIER_VERSION;
  bindErrors(module);
  bindScan(module);
  bindSkeleton(module);
  bindOptions(module);
  bindReconstruct(module);
  bindDecisions(module);
  bindEvaluate(module);
  bindSimulate(module);
}
