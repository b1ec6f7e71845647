// SPDX-License-Identifier: MIT
#include "python/bindings/values.h"

#include <memory>

#include "output/document/printing.h"

namespace camlaw::python {
namespace {

nb::object optional_number(const std::optional<double>& value) {
  return value ? nb::cast(*value) : nb::none();
}

nb::dict dict_of_axis(const cli::Axis& axis) {
  nb::dict result;
  result["label"] = axis.label;
  result["unit"] = axis.unit;
  result["lower"] = optional_number(axis.lower);
  result["upper"] = optional_number(axis.upper);
  return result;
}

nb::dict dict_of_line(const cli::Line& line) {
  nb::dict result;
  result["name"] = line.name;
  result["x"] = array_of(line.x);
  result["y"] = array_of(line.y);
  result["colour"] = line.colour;
  result["dashed"] = line.dashed;
  result["width"] = line.width;
  return result;
}

const char* shape_name(cli::MarkerShape shape) {
  switch (shape) {
    case cli::MarkerShape::Diamond:
      return "diamond";
    case cli::MarkerShape::Square:
      return "square";
    case cli::MarkerShape::Cross:
      return "cross";
    case cli::MarkerShape::Circle:
      break;
  }
  return "circle";
}

nb::dict dict_of_markers(const cli::Markers& markers) {
  std::vector<double> x, y;
  nb::list labels;
  for (const cli::Marker& marker : markers.points) {
    x.push_back(marker.x);
    y.push_back(marker.y);
    labels.append(marker.label);
  }
  nb::dict result;
  result["name"] = markers.name;
  result["x"] = array_of(std::move(x));
  result["y"] = array_of(std::move(y));
  result["labels"] = labels;
  result["colour"] = markers.colour;
  result["shape"] = shape_name(markers.shape);
  result["filled"] = markers.filled;
  result["size"] = markers.size;
  return result;
}

nb::dict dict_of_panel(const cli::Panel& panel) {
  nb::list lines, markers;
  for (const cli::Line& line : panel.lines) lines.append(dict_of_line(line));
  for (const cli::Markers& some : panel.markers) markers.append(dict_of_markers(some));
  nb::dict result;
  result["title"] = panel.title;
  result["x"] = dict_of_axis(panel.x);
  result["y"] = dict_of_axis(panel.y);
  result["lines"] = lines;
  result["markers"] = markers;
  return result;
}

}  // namespace

Array array_of(std::vector<double> values) {
  auto owned = std::make_unique<std::vector<double>>(std::move(values));
  std::vector<double>* const numbers = owned.get();
  const nb::capsule owner(owned.release(),
                          [](void* p) noexcept { delete static_cast<std::vector<double>*>(p); });
  return Array(numbers->data(), {numbers->size()}, owner);
}

nb::object python_of(const problems::Json& value) {
  using Type = problems::Json::value_t;
  switch (value.type()) {
    case Type::object: {
      nb::dict result;
      for (const auto& [key, item] : value.items()) result[nb::cast(key)] = python_of(item);
      return result;
    }
    case Type::array: {
      nb::list result;
      for (const auto& item : value) result.append(python_of(item));
      return result;
    }
    case Type::string:
      return nb::cast(cli::unshaded(value.get<std::string>()));
    case Type::boolean:
      return nb::cast(value.get<bool>());
    case Type::number_integer:
      return nb::cast(value.get<std::int64_t>());
    case Type::number_unsigned:
      return nb::cast(value.get<std::uint64_t>());
    case Type::number_float:
      return nb::cast(value.get<double>());
    default:
      return nb::none();
  }
}

nb::dict dict_of(const cli::Figure& figure) {
  nb::list panels;
  for (const cli::Panel& panel : figure.panels) panels.append(dict_of_panel(panel));
  nb::dict result;
  result["title"] = figure.title;
  result["subtitle"] = figure.subtitle;
  result["columns"] = figure.columns;
  result["panels"] = panels;
  return result;
}

}  // namespace camlaw::python
