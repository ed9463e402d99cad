#include "python/options.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/pipeline/option_text.h"
#include "core/pipeline/preset.h"
#include "core/pipeline/presets.h"
#include "python/bindings.h"
#include "python/words.h"

#include <pybind11/eigen.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <sstream>
#include <vector>

namespace espalier::python {

py::object valueOf(const Option& option, double value) {
  if (option.kind == OptionKind::flag) return py::bool_(value != 0);
  if (option.kind == OptionKind::choice) return py::str(option.wordFor(value));
  const bool isWhole = value == std::round(value); // if not, it is refused by the run
  if (option.kind == OptionKind::count && isWhole) return py::int_(std::llround(value));
  return py::float_(value);
}

namespace {

/// The options of one step: what `options.contract` is.
struct StepOptions {
  std::shared_ptr<HeldOptions> all;
  const Step* step = nullptr;

  [[nodiscard]] const Method& method() const { return chosenMethod(*step, all->options); }
};

/// What the program says of an option that the method of a step has not.
std::string noSuchOption(const StepOptions& self, const std::string& name) {
  PipelineOptions asked{.methods = self.all->options.methods};
  asked.settings[self.step->name][name] = {};
  try {
    requireKnown(asked);
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

/// A value as one would type it.
std::string typedText(const py::object& value) {
  if (PyBool_Check(value.ptr())) return value.is(py::bool_(true)) ? "yes" : "no";
  if (!py::isinstance<py::str>(value) && PyNumber_Check(value.ptr()) != 0) {
    const double number = PyFloat_AsDouble(value.ptr());
    if (PyErr_Occurred() == nullptr && std::isfinite(number)) return plainDecimal(number);
    PyErr_Clear();
  }
  return py::str(value);
}

py::object valueIn(const StepOptions& self, const std::string& name) {
  const Method& method = self.method();
  const auto option = std::ranges::find(method.options, name, &Option::name);
  if (option == method.options.end()) throwUnknownName(noSuchOption(self, name));
  Rule rule = option->rule;
  const auto& settings = self.all->options.settings;
  if (const auto step = settings.find(self.step->name); step != settings.end())
    if (const auto set = step->second.find(name); set != step->second.end()) rule = set->second;
  return rule.isFixed() ? valueOf(*option, rule.fixed) : py::str(rule.text());
}

void setValue(const StepOptions& self, const std::string& name, const py::object& value) {
  self.all->options.setText(*self.step, name, typedText(value), self.all->meters);
}

void resetValue(const StepOptions& self, const std::string& name) {
  auto& settings = self.all->options.settings;
  if (const auto step = settings.find(self.step->name); step != settings.end())
    step->second.erase(name);
}

std::string methodOf(const StepOptions& self) {
  return self.method().name;
}

void setMethod(const StepOptions& self, const std::string& name) {
  self.all->options.choose(*self.step, name);
}

void resetMethod(const StepOptions& self) {
  self.all->options.choose(*self.step, self.step->methods.front().name);
  self.all->options.methods.erase(self.step->name); // as if none had been chosen
}

/// `property`, which reads, sets and resets.
template <class Get, class Set, class Reset>
py::object propertyOf(const Get& get, const Set& set, const Reset& reset, const std::string& doc) {
  return py::module_::import("builtins")
      .attr("property")(py::cpp_function(get), py::cpp_function(set), py::cpp_function(reset), doc);
}

/// "laplacian: length, default ..., range ...", and what it does, for each method that has it.
std::string documentOf(const Step& step, const std::string& name) {
  std::string text;
  for (const Method& method : step.methods)
    for (const Option& option : method.options)
      if (option.name == name)
        text += (text.empty() ? "" : "\n") + method.name + ": " + summaryOf(option) + "\n    " +
                option.help;
  return text;
}

std::string documentOf(const Step& step) {
  std::string text = step.help + "\n\nMethods, the first by default:\n";
  for (const Method& method : step.methods) {
    text += "\n" + method.name + "\n    " + method.help + "\n";
    if (!method.source.empty()) text += "    Source: " + method.source + "\n";
  }
  return text;
}

/// Words as a type of Python has them: "Literal['none', 'slab']".
template <class Named> std::string literalOf(const std::vector<Named>& all) {
  std::string words;
  for (const Named& each : all)
    words += (words.empty() ? "'" : ", '") + each.name + "'";
  return "Literal[" + words + "]";
}

/// What an option may be set to, as a type of Python.
std::string typeOf(const Option& option) {
  switch (option.kind) {
  case OptionKind::length:
  case OptionKind::angle:
    return "float | str";
  case OptionKind::ratio:
  case OptionKind::curve:
    return "float";
  case OptionKind::count:
    return "int";
  case OptionKind::choice:
    return literalOf(option.choices);
  case OptionKind::flag:
    return "bool";
  }
  return {};
}

/// "ContractOptions"
std::string classNameOf(const Step& step) {
  std::string name = step.name + "Options";
  name.front() = static_cast<char>(name.front() - 'a' + 'A');
  return name;
}

/// The name of an option as an attribute, where it is no word of Python.
py::str attributeOf(const Option& option) {
  const py::str name(option.name);
  const bool isWord = py::module_::import("keyword").attr("iskeyword")(name).cast<bool>();
  return isWord ? py::str(option.name + "_") : name;
}

/// The class of the options of a step, with a property for each that any of its methods has.
py::object classOf(const Step& step, const py::object& base) {
  py::dict members;
  members["__module__"] = "espalier";
  members["__slots__"] = py::tuple();
  members["__doc__"] = documentOf(step);
  py::dict types;
  types["method"] = literalOf(step.methods);
  members["method"] = propertyOf(&methodOf, &setMethod, &resetMethod,
                                 "The name of the method. Another begins with its defaults.");
  for (const Method& method : step.methods)
    for (const Option& option : method.options) {
      const std::string& name = option.name;
      const py::str attribute = attributeOf(option);
      if (members.contains(attribute)) continue;
      members[attribute] = propertyOf(
          [name](const StepOptions& self) { return valueIn(self, name); },
          [name](const StepOptions& self, const py::object& value) { setValue(self, name, value); },
          [name](const StepOptions& self) { resetValue(self, name); }, documentOf(step, name));
      types[attribute] = typeOf(option);
    }
  members["__annotations__"] = types;
  return py::type::of(base)(classNameOf(step), py::make_tuple(base), members);
}

bool isOfPython(const std::string& name) {
  return name.starts_with('_');
}

/// Sets attributes that there are, and reports others as the program does.
template <class Unknown>
void setAttribute(const py::object& self, const std::string& name, const py::object& value,
                  const Unknown& unknown) {
  if (!isOfPython(name) && !py::hasattr(py::type::of(self), name.c_str())) unknown();
  if (PyObject_GenericSetAttr(self.ptr(), py::str(name).ptr(), value.ptr()) != 0)
    throw py::error_already_set();
}

[[noreturn]] void reportOption(const StepOptions& self, const std::string& name) {
  const std::string problem = isOfPython(name) ? std::string() : noSuchOption(self, name);
  if (problem.empty()) throw py::attribute_error(name);
  throwUnknownName(problem);
}

[[noreturn]] void reportStep(const std::string& name) {
  if (isOfPython(name)) throw py::attribute_error(name);
  try {
    (void)stepNamed(name);
  } catch (const Error& error) {
    throwUnknownName(error.what());
  }
  throw py::attribute_error(name);
}

std::shared_ptr<HeldOptions> optionsOf(const std::filesystem::path& preset, const std::string& up,
                                       const std::optional<Eigen::Vector3d>& root,
                                       const std::optional<std::string>& unit) {
  auto held = std::make_shared<HeldOptions>();
  if (unit) {
    held->unit = *unit;
    held->meters = metersIn(*unit);
  }
  held->options = presetIn(preset.string(), held->meters);
  held->options.up = upAxisIn(up);
  held->options.root = root;
  return held;
}

std::string documentOfPresets() {
  std::string text = "preset: one of these, or a JSON file of steps and options.\n";
  for (const NamedPreset& preset : presets())
    text += "    " + preset.name + ": " + preset.help + "\n";
  return text + "up: the axis that points up: x, y or z.\n"
                "root: the foot of the plant, a place; None: it is found.\n"
                "unit: of the scan, mm, cm or m: lengths can then be set as '38 mm'.";
}

std::string presetText(const HeldOptions& self) {
  std::ostringstream out;
  writePreset(out, self.options);
  std::string text = out.str();
  text.pop_back(); // the end of the line
  return text;
}

void bindSteps(py::class_<HeldOptions, std::shared_ptr<HeldOptions>>& options,
               py::module_& module) {
  py::class_<StepOptions> base(module, "StepOptions", ofPlainType(),
                               "The method of a step, and its options.");
  base.def(py::init([](std::shared_ptr<HeldOptions> all, const std::string& step) {
             return StepOptions{std::move(all), &stepNamed(step)};
           }),
           py::arg("options"), py::arg("step"),
           documented("__init__(self, options, step)",
                      "What the attribute of that name of the options is.")
               .c_str());
  base.def("__getattr__", &reportOption, py::arg("name"),
           documented("__getattr__(self, name)", "Reports a name that is no option.").c_str());
  base.def(
      "__setattr__",
      [](const py::object& self, const std::string& name, const py::object& value) {
        setAttribute(self, name, value,
                     [&] { reportOption(self.cast<const StepOptions&>(), name); });
      },
      py::arg("name"), py::arg("value"),
      documented("__setattr__(self, name, value)",
                 "Sets an option, or reports a name that is none.")
          .c_str());
  for (const Step& step : pipelineSteps()) {
    const py::object type = classOf(step, base);
    module.attr(classNameOf(step).c_str()) = type;
    options.def_property_readonly(
        step.name.c_str(),
        [type, name = step.name](const py::object& self) { return type(self, name); },
        step.help.c_str());
  }
}

} // namespace

void bindOptions(py::module_& module) {
  py::class_<HeldOptions, std::shared_ptr<HeldOptions>> options(
      module, "Options", ofPlainType(),
      "How a plant is reconstructed: for each step its method, and the options of that.\n\n"
      "    options = espalier.Options()\n"
      "    options.contract.radius = '6 spacings'\n"
      "    del options.contract.radius  # back to the rule\n\n"
      "What is not set follows from the scan by a rule. A length is a number in the unit of the\n"
      "scan, or a text: '6 spacings' of its points, '0.02 heights' of the plant, '3 thicknesses' "
      "of\n"
      "thin wood, '2 scatters' of the points or, if the unit is known, '38 mm'; an angle is in\n"
      "degrees. Names and values are those of `espalier methods`. repr() is the preset as JSON.");
  options.def(py::init(&optionsOf), py::arg("preset") = presets().front().name, py::kw_only(),
              py::arg("up") = "z", py::arg("root") = py::none(), py::arg("unit") = py::none(),
              documented("__init__(self, preset='" + presets().front().name +
                             "', *, up='z', root=None, unit=None)",
                         documentOfPresets())
                  .c_str());
  options.def_property(
      "up", [](const HeldOptions& self) { return nameOf(self.options.up); },
      [](HeldOptions& self, const std::string& up) { self.options.up = upAxisIn(up); },
      "The axis that points up: x, y or z.");
  options.def_property(
      "root", [](const HeldOptions& self) { return self.options.root; },
      [](HeldOptions& self, const std::optional<Eigen::Vector3d>& root) {
        self.options.root = root;
      },
      "The foot of the plant, a place in the frame of the scan; None: it is found.");
  options.def_property_readonly(
      "unit",
      [](const HeldOptions& self) {
        return self.unit.empty() ? std::nullopt : std::optional(self.unit);
      },
      "The unit of the scan: mm, cm or m; None: it is not known.");
  options.def("__repr__", &presetText);
  options.def(
      "__getattr__", [](const HeldOptions&, const std::string& name) { reportStep(name); },
      py::arg("name"),
      documented("__getattr__(self, name)", "Reports a name that is no step.").c_str());
  options.def(
      "__setattr__",
      [](const py::object& self, const std::string& name, const py::object& value) {
        setAttribute(self, name, value, [&] { reportStep(name); });
      },
      py::arg("name"), py::arg("value"),
      documented("__setattr__(self, name, value)", "Sets an attribute, or reports a name that is "
                                                   "none.")
          .c_str());
  bindSteps(options, module);
}

} // namespace espalier::python
