// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Dense>
#include <map>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

/// Files for drives as their makers' descriptions have them read (docs/exports.md, "Drives"), and
/// the motions that the controllers make of them: written from those descriptions, with nothing of
/// what writes the files.
namespace camlaw::drive_readers {

struct Point {
  double x = 0, y = 0, v = 0, a = 0;
};

enum class Joined { ByLines, ByQuintics, BySpline };

/// What a controller has read.
struct Cam {
  std::vector<Point> points;
  Joined joined = Joined::ByLines;
  double start_slope = 0, end_slope = 0;

  mutable std::vector<double> bends = {};  ///< of the spline, once they were asked for

  double at(double x) const;
};

inline std::string without_comments(const std::string& text) {
  std::string result;
  std::size_t from = 0;
  for (std::size_t open; (open = text.find("(*", from)) != std::string::npos;) {
    result += text.substr(from, open - from);
    const std::size_t shut = text.find("*)", open + 2);
    if (shut == std::string::npos) throw std::runtime_error("a comment without end");
    from = shut + 2;
  }
  return result + text.substr(from);
}

/// A literal of IEC 61131-3: a number with a point, or an integer.
inline double literal(const std::string& text) {
  static const std::regex form(R"(-?[0-9]+(\.[0-9]+([Ee][+-]?[0-9]+)?)?)");
  if (!std::regex_match(text, form)) throw std::runtime_error("no literal: " + text);
  return std::stod(text);
}

/// The text between "NAME : ARRAY[...] OF TYPE := [" and "];", and the array's bounds.
struct Array {
  std::string bounds, type, content;
};
inline Array array_of(const std::string& text) {
  static const std::regex head(R"((\w+)\s*:\s*ARRAY\[([^\]]*)\]\s+OF\s+(\w+)\s*:=\s*\[)");
  std::smatch found;
  if (!std::regex_search(text, found, head)) throw std::runtime_error("no array");
  const std::string rest = found.suffix();
  const std::size_t end = rest.find("];");
  if (end == std::string::npos) throw std::runtime_error("an array without end");
  return {found[2], found[3], rest.substr(0, end)};
}

/// The elements "(name := value, ...)" of an array.
inline std::vector<std::map<std::string, std::string>> structures(const std::string& content) {
  std::vector<std::map<std::string, std::string>> all;
  static const std::regex element(R"(\(([^()]*)\))"), member(R"((\w+)\s*:=\s*([^,\s]+))");
  for (std::sregex_iterator e(content.begin(), content.end(), element), none; e != none; ++e) {
    const std::string inside = (*e)[1];
    auto& members = all.emplace_back();
    for (std::sregex_iterator m(inside.begin(), inside.end(), member); m != none; ++m) {
      members[(*m)[1]] = (*m)[2];
    }
  }
  return all;
}

inline void check_rows(const std::string& text, const char* name, std::size_t rows) {
  std::smatch found;
  if (!std::regex_search(text, found, std::regex(std::string(name) + R"(\s*:=\s*(\d+))")) ||
      std::stoul(found[1]) != rows) {
    throw std::runtime_error("the number of rows is not stated right");
  }
}

/// MC_CAM_REF, example 1: "ARRAY[0..n, 0..1] OF LREAL", first column the ascending masters.
inline Cam beckhoff_points(const std::string& file) {
  const std::string text = without_comments(file);
  const Array array = array_of(text);
  if (array.type != "LREAL") throw std::runtime_error("no table of LREAL");
  std::vector<double> numbers;
  std::istringstream words(std::regex_replace(array.content, std::regex("[,\\s]+"), " "));
  for (std::string word; words >> word;) numbers.push_back(literal(word));
  Cam cam;
  for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) {
    cam.points.push_back({numbers[i], numbers[i + 1]});
  }
  if (array.bounds != "0.." + std::to_string(cam.points.size() - 1) + ", 0..1") {
    throw std::runtime_error("bounds that are not the table's: " + array.bounds);
  }
  check_rows(text, "NoOfRows", cam.points.size());
  check_rows(text, "NoOfColumns", 2);
  return cam;
}

/// MC_MotionFunctionPoint: indices from 1 without gaps, the function of a point holds to the next.
inline Cam beckhoff_motion(const std::string& file) {
  const std::string text = without_comments(file);
  const Array array = array_of(text);
  if (array.type != "MC_MotionFunctionPoint") throw std::runtime_error("no motion function");
  Cam cam{{}, Joined::ByQuintics};
  for (const auto& point : structures(array.content)) {
    const auto member = [&](const char* name) { return literal(point.at(name)); };
    if (member("PointIndex") != static_cast<double>(cam.points.size() + 1)) {
      throw std::runtime_error("a gap between the points");
    }
    if (point.at("FunctionType") != "MOTIONFUNCTYPE_POLYNOM5_MM" ||
        point.at("PointType") != "MOTIONPOINTTYPE_MOTION") {
      throw std::runtime_error("a point of another kind");
    }
    cam.points.push_back(
        {member("MasterPos"), member("SlavePos"), member("SlaveVelo"), member("SlaveAcc")});
  }
  check_rows(text, "NoOfRows", cam.points.size());
  return cam;
}

/// "Display Generated Code": an array of SMC_CAMXYVA and its MC_CAM_REF of type 3 (XYVA).
inline Cam codesys(const std::string& file) {
  const std::string text = without_comments(file);
  const Array array = array_of(text);
  if (array.type != "SMC_CAMXYVA") throw std::runtime_error("no XYVA");
  Cam cam{{}, Joined::ByQuintics};
  for (const auto& point : structures(array.content)) {
    const auto member = [&](const char* name) { return literal(point.at(name)); };
    cam.points.push_back({member("dX"), member("dY"), member("dV"), member("dA")});
  }
  check_rows(text, "nElements", cam.points.size());
  check_rows(text, "byType", 3);
  return cam;
}

/// LCamHdl_typeBasicPoint: at most 51 points with increasing leading values.
inline Cam siemens(const std::string& file) {
  const Array array = array_of(without_comments(file));
  if (array.type != "LCamHdl_typeBasicPoint") throw std::runtime_error("no basic points");
  Cam cam{{}, Joined::ByQuintics};
  for (const auto& point : structures(array.content)) {
    const auto member = [&](const char* name) { return literal(point.at(name)); };
    cam.points.push_back({member("leadingValue"), member("followingValue"), member("velocityRatio"),
                          member("accelerationRatio")});
  }
  if (cam.points.size() > 51) throw std::runtime_error("more than 51 points");
  if (array.bounds != "1.." + std::to_string(cam.points.size())) {
    throw std::runtime_error("bounds that are not the array's: " + array.bounds);
  }
  return cam;
}

/// Cam Loader: "x y // comment", points in ascending order of x, at least two.
inline Cam lenze(const std::string& file) {
  Cam cam;
  std::istringstream lines(file);
  static const std::regex form(R"((-?[0-9]+[.,]?[0-9]*)[ \t]+(-?[0-9]+[.,]?[0-9]*)([ \t]+//.*)?)");
  for (std::string line; std::getline(lines, line);) {
    if (line.empty()) continue;
    std::smatch found;
    if (!std::regex_match(line, found, form)) throw std::runtime_error("no point: " + line);
    cam.points.push_back({std::stod(found[1]), std::stod(found[2])});
  }
  return cam;
}

/// The CAM data type: REAL Master and Slave, SegmentType 1 cubic; MCCP with the slopes at the ends.
inline Cam rockwell(const std::string& file) {
  const std::string text = without_comments(file);
  Cam cam{{}, Joined::BySpline};
  static const std::regex point(
      R"(Cam\[(\d+)\]\.Master := ([^;]+); Cam\[\1\]\.Slave := ([^;]+); Cam\[\1\]\.SegmentType := 1;)");
  for (std::sregex_iterator p(text.begin(), text.end(), point), none; p != none; ++p) {
    if (std::stoul((*p)[1]) != cam.points.size()) throw std::runtime_error("a gap");
    const auto real = [](const std::string& word) {
      return static_cast<double>(static_cast<float>(literal(word)));
    };
    cam.points.push_back({real((*p)[2]), real((*p)[3])});
  }
  static const std::regex call(R"(MCCP\(\w+, Cam\[0\], (\d+), ([^,]+), ([^,]+), \w+\[0\]\);)");
  std::smatch found;
  if (!std::regex_search(text, found, call) || std::stoul(found[1]) != cam.points.size()) {
    throw std::runtime_error("no MCCP over all points");
  }
  cam.start_slope = literal(found[2]), cam.end_slope = literal(found[3]);
  return cam;
}

/// Second derivatives of the clamped cubic spline, from continuous slopes:
/// h_i M_i + 2 (h_i + h_i+1) M_i+1 + h_i+1 M_i+2 = 6 (d_i+1 - d_i).
inline std::vector<double> bends_of(const Cam& cam) {
  const auto n = static_cast<Eigen::Index>(cam.points.size());
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd b(n);
  const auto width = [&](Eigen::Index i) {
    return cam.points[static_cast<std::size_t>(i + 1)].x -
           cam.points[static_cast<std::size_t>(i)].x;
  };
  const auto slope = [&](Eigen::Index i) {
    return (cam.points[static_cast<std::size_t>(i + 1)].y -
            cam.points[static_cast<std::size_t>(i)].y) /
           width(i);
  };
  a(0, 0) = 2 * width(0), a(0, 1) = width(0), b(0) = 6 * (slope(0) - cam.start_slope);
  for (Eigen::Index i = 1; i + 1 < n; ++i) {
    a(i, i - 1) = width(i - 1), a(i, i) = 2 * (width(i - 1) + width(i)), a(i, i + 1) = width(i);
    b(i) = 6 * (slope(i) - slope(i - 1));
  }
  a(n - 1, n - 1) = 2 * width(n - 2), a(n - 1, n - 2) = width(n - 2);
  b(n - 1) = 6 * (cam.end_slope - slope(n - 2));
  const Eigen::VectorXd m = a.partialPivLu().solve(b);
  return {m.data(), m.data() + n};
}

inline double Cam::at(double x) const {
  std::size_t k = 0;
  while (k + 2 < points.size() && points[k + 1].x <= x) ++k;
  const Point &p = points[k], &q = points[k + 1];
  const double h = q.x - p.x, t = x - p.x;
  if (!(h > 0)) throw std::runtime_error("masters that do not rise");
  if (joined == Joined::ByLines) return p.y + t * (q.y - p.y) / h;
  if (joined == Joined::BySpline) {
    if (bends.empty()) bends = bends_of(*this);
    const double m = bends[k], n = bends[k + 1], u = q.x - x;
    return m * u * u * u / (6 * h) + n * t * t * t / (6 * h) + (p.y / h - m * h / 6) * u +
           (q.y / h - n * h / 6) * t;
  }
  // c_0 + c_1 z + ... + c_5 z^5, z = t / h, from its six conditions.
  Eigen::Matrix<double, 6, 6> a;
  a << 1, 0, 0, 0, 0, 0,  //
      0, 1, 0, 0, 0, 0,   //
      0, 0, 2, 0, 0, 0,   //
      1, 1, 1, 1, 1, 1,   //
      0, 1, 2, 3, 4, 5,   //
      0, 0, 2, 6, 12, 20;
  Eigen::Matrix<double, 6, 1> b;
  b << p.y, h * p.v, h * h * p.a, q.y, h * q.v, h * h * q.a;
  const Eigen::Matrix<double, 6, 1> c = a.fullPivLu().solve(b);
  const double z = t / h;
  double value = 0;
  for (int i = 5; i >= 0; --i) value = value * z + c(i);
  return value;
}

}  // namespace camlaw::drive_readers
