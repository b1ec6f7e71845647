// SPDX-License-Identifier: MIT
#include "problems/law_files/pieces_json.h"

#include <fmt/format.h>

#include <cmath>

#include "kinematics/peaks.h"
#include "problems/law_files/json_text.h"

namespace camlaw::problems {
namespace {

Json plain(double value) {
  if (std::isnan(value)) return nullptr;
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  return value;
}

struct CurveToJson {
  Json operator()(const HalfEllipse<double>& c) const {
    return {{"curve", "half-ellipse"}, {"integrations", c.integrations}};
  }
  Json operator()(const Ellipse<double>& c) const { return {{"curve", "ellipse"}, {"n", c.n}}; }
  Json operator()(const InclinedSine<double>& c) const {
    return {{"curve", "inclined-sine"}, {"e", c.e}};
  }
  Json operator()(const Power<double>& c) const {
    return {{"curve", "power"}, {"exponent", c.exponent}};
  }
};

Json piece_to_json(const Piece<double>& piece) {
  Json harmonics = Json::array(), curves = Json::array();
  for (const auto& h : piece.harmonics) {
    harmonics.push_back({{"sine", h.sine}, {"cosine", h.cosine}, {"frequency", h.frequency}});
  }
  for (const auto& c : piece.curves) {
    Json term = std::visit(CurveToJson{}, c.curve);
    term["amplitude"] = c.amplitude;
    term["rate"] = c.rate;
    term["shift"] = c.shift;
    curves.push_back(std::move(term));
  }
  return {{"begin", piece.begin},
          {"end", piece.end},
          {"origin", piece.origin},
          {"polynomial", piece.polynomial},
          {"harmonics", std::move(harmonics)},
          {"curves", std::move(curves)}};
}

[[noreturn]] void refuse(const std::string& why) { throw std::invalid_argument(why); }

/// An object's value; `what` says where: "pieces[2].harmonics[1]".
const Json& value(const Json& object, const char* key, const std::string& what) {
  if (!object.is_object()) refuse(fmt::format("{} is not an object", what));
  const auto found = object.find(key);
  if (found == object.end()) refuse(fmt::format("{} has no {}", what, key));
  return *found;
}

double number_of(const Json& number, const std::string& what) {
  if (!number.is_number()) refuse(fmt::format("{} is not a number", what));
  return number.get<double>();
}

double number_of(const Json& object, const char* key, const std::string& what) {
  return number_of(value(object, key, what), what + "." + key);
}

/// What a law of the catalogue stays within, so that every search of a curve ends in good time.
constexpr std::size_t kMostTerms = 101, kMostHarmonics = 1000;  ///< of a polynomial; of a piece
constexpr double kMostFrequency = 1e4, kMostExponent = 100;
constexpr double kMostLean = 0.84;  ///< the cotangent of 50 degrees

/// A number of a file between two bounds.
double bounded(const Json& object, const char* key, const std::string& what, double low,
               double high) {
  const double number = number_of(object, key, what);
  if (number >= low && number <= high) return number;
  refuse(fmt::format("{}.{} = {:.6g} is outside {:.6g} .. {:.6g}", what, key, number, low, high));
}

void check_count(std::size_t count, std::size_t most, const std::string& what) {
  if (count > most)
    refuse(fmt::format("{} has {} terms; at most {} are accepted", what, count, most));
}

/// Does one(item, place) for each item of a list.
template <class One>
void each(const Json& list, const std::string& what, const One& one) {
  if (!list.is_array()) refuse(fmt::format("{} is not a list", what));
  for (std::size_t i = 0; i < list.size(); ++i) one(list[i], fmt::format("{}[{}]", what, i + 1));
}

PieceCurve<double> curve_of(const Json& term, const std::string& what) {
  const Json& name = value(term, "curve", what);
  if (name == "half-ellipse") {
    const Json& count = value(term, "integrations", what);
    if (!count.is_number_integer() || count < 1 || count > 2) {
      refuse(fmt::format("{}.integrations is not 1 or 2", what));
    }
    return HalfEllipse<double>{count.get<int>()};
  }
  if (name == "ellipse") return Ellipse<double>{bounded(term, "n", what, 0.2, 5)};
  if (name == "inclined-sine")
    return InclinedSine<double>{bounded(term, "e", what, -kMostLean, kMostLean)};
  if (name == "power") return Power<double>{bounded(term, "exponent", what, 2, kMostExponent)};
  refuse(fmt::format("{}.curve must be half-ellipse, ellipse, inclined-sine or power", what));
}

Piece<double> piece_of(const Json& object, const std::string& what) {
  Piece<double> piece{number_of(object, "begin", what),
                      number_of(object, "end", what),
                      number_of(object, "origin", what),
                      {},
                      {},
                      {}};
  each(value(object, "polynomial", what), what + ".polynomial",
       [&](const Json& c, const std::string& at) { piece.polynomial.push_back(number_of(c, at)); });
  each(value(object, "harmonics", what), what + ".harmonics",
       [&](const Json& h, const std::string& at) {
         piece.harmonics.push_back({number_of(h, "sine", at), number_of(h, "cosine", at),
                                    bounded(h, "frequency", at, -kMostFrequency, kMostFrequency)});
       });
  check_count(piece.polynomial.size(), kMostTerms, what + ".polynomial");
  check_count(piece.harmonics.size(), kMostHarmonics, what + ".harmonics");
  each(value(object, "curves", what), what + ".curves", [&](const Json& c, const std::string& at) {
    piece.curves.push_back({number_of(c, "amplitude", at), number_of(c, "rate", at),
                            number_of(c, "shift", at), curve_of(c, at)});
  });
  return piece;
}

}  // namespace

Json law_file(const Law<double>& law, const std::string& title, const Json& provenance) {
  const auto peak = peaks(law);
  const auto lambda = limit_index(peak);
  return {{"format", kLawFormat.text()},
          {"title", title},
          {"ends", to_string(law.ends())},
          {"constants",
           {{"C_v", plain(peak.max_velocity())},
            {"C_a", plain(peak.max_acceleration())},
            {"C_j", plain(peak.max_jerk())},
            {"C_Mdyn", plain(peak.max_dynamic_moment())},
            {"lambda", lambda ? plain(*lambda) : Json(nullptr)}}},
          {"provenance", provenance},
          {"pieces", pieces_to_json(law)}};
}

Json pieces_to_json(const Law<double>& law) {
  Json result = Json::array();
  for (const auto& piece : law.pieces()) result.push_back(piece_to_json(piece));
  return result;
}

Law<double> law_from_json(const Json& list, Ends ends) {
  std::vector<Piece<double>> pieces;
  each(list, "pieces", [&](const Json& piece, const std::string& what) {
    pieces.push_back(piece_of(piece, what));
  });
  return Law<double>(std::move(pieces), ends);
}

Ends ends_of(const std::string& text) {
  constexpr End kAll[] = {End::Rest, End::Velocity, End::Reversal, End::Motion};
  for (const End begin : kAll) {
    for (const End end : kAll) {
      if (to_string(Ends{begin, end}) == text) return {begin, end};
    }
  }
  refuse(fmt::format("ends '{}' are not among those of VDI 2143, such as R-R", text));
}

}  // namespace camlaw::problems
