#pragma once

#include "core/base/error.h"
#include "core/io/formats.h"

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

namespace espalier {

/// Makes sure, before the work, that no two results go to one file, by whatever paths and links. An
/// empty path is a file nobody asked for.
/// @throws WrongUsage
void requireApart(const std::vector<std::string>& outputs);

/// Makes sure, before the work rather than after it, that a file can be written. An empty path is
/// a file nobody asked for. What killed runs left in its folder is removed.
/// @param inputs files that are read, which the output must not replace
/// @throws Error which says what to choose instead
void requireOutput(const std::string& path, const std::vector<std::string>& inputs);

/// The same of a file that holds points or a structure, with an extension that says how.
void requireOutput(const std::string& path, Content content,
                   const std::vector<std::string>& inputs);

/// Writes a file, which is whole or as it was before, and reports it on standard error. An empty
/// path is a file nobody asked for.
/// @param what  it holds, to be reported; may be empty
/// @throws Error why it cannot be written
void writeAndReport(const std::string& path, const std::function<void(std::ostream&)>& write,
                    const std::string& what = {});

/// JSON as text that people can read, too. A name of a file that is no UTF-8, as JSON is, gets a
/// sign that says so for what it cannot hold, and a note is printed.
[[nodiscard]] std::string textOf(const nlohmann::ordered_json& json);

/// Writes JSON as writeAndReport does. An empty path is a file nobody asked for.
void writeJson(const std::string& path, const nlohmann::ordered_json& json);

/// Writes a structure in the format of the extension. Reports on standard error what was written,
/// and what the format does not keep.
/// @param style  of an MTG of a structure without scales of its own
/// @param unit   of its length, to be named; may be empty
/// @throws Error why it cannot be written
void writeAndReport(const std::string& path, const Structure& structure, MtgStyle style,
                    const std::string& unit = {});

/// The same of points.
/// @throws Cancelled if `progress` asks to stop
void writeAndReport(const std::string& path, const PointCloud& cloud,
                    const Eigen::Matrix3Xf& positions, const Progress& progress);

/// What `work` returns; an Error of it is said to be about `file`.
template <class Work> auto about(const std::string& file, const Work& work) {
  try {
    return work();
  } catch (const Error& error) {
    throw Error(file + ": " + error.what());
  }
}

} // namespace espalier
