// SPDX-License-Identifier: MIT
#include "problems/law_files/law_file.h"

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "problems/law_files/json_text.h"
#include "problems/law_files/pieces_json.h"
#include "problems/statement/statement.h"
#include "tests/temporary_folder.h"

namespace camlaw::problems::law_file_test {
namespace {

namespace fs = std::filesystem;
using Catch::Contains;

/// A folder of its own, that of one's own laws while it is there.
class OwnFolder {
 public:
  OwnFolder() { setenv(kOwnLaws, folder().c_str(), 1); }
  OwnFolder(const OwnFolder&) = delete;
  OwnFolder& operator=(const OwnFolder&) = delete;
  ~OwnFolder() { unsetenv(kOwnLaws); }
  std::string put(const std::string& name, const std::string& text) const {
    std::string path = folder_ / name;
    std::ofstream(path) << text;
    return path;
  }
  std::string folder() const { return folder_.path(); }

 private:
  camlaw::testing::Folder folder_;
};

std::string text_of(const Law<double>& law) { return law_file(law, "a title", Json{}).dump(2); }

void check_same(const Piece<double>& a, const Piece<double>& b) {
  CHECK(a.begin == b.begin);
  CHECK(a.end == b.end);
  CHECK(a.origin == b.origin);
  CHECK(a.polynomial == b.polynomial);
  REQUIRE(a.harmonics.size() == b.harmonics.size());
  for (std::size_t k = 0; k < a.harmonics.size(); ++k) {
    CHECK(a.harmonics[k].sine == b.harmonics[k].sine);
    CHECK(a.harmonics[k].cosine == b.harmonics[k].cosine);
    CHECK(a.harmonics[k].frequency == b.harmonics[k].frequency);
  }
  REQUIRE(a.curves.size() == b.curves.size());
  for (std::size_t k = 0; k < a.curves.size(); ++k) {
    CHECK(a.curves[k].amplitude == b.curves[k].amplitude);
    CHECK(a.curves[k].rate == b.curves[k].rate);
    CHECK(a.curves[k].shift == b.curves[k].shift);
    CHECK(a.curves[k].curve.index() == b.curves[k].curve.index());
  }
}

}  // namespace

TEST_CASE("Every law of the catalogue comes back from its file to the last bit", "[law-files]") {
  const OwnFolder own;
  for (const Family& family : catalogue()) {
    INFO(family.name);
    const Law<double> law = family.make(family.defaults());
    const Law<double> read = read_law_file(own.put("law.json", text_of(law))).law();
    REQUIRE(read.pieces().size() == law.pieces().size());
    for (std::size_t i = 0; i < law.pieces().size(); ++i) {
      check_same(read.pieces()[i], law.pieces()[i]);
    }
    CHECK(read.ends() == law.ends());
    for (const double x : {0.0, 0.1234, 0.5, 0.77, 1.0}) {
      const auto a = law(x, Side::Left), b = read(x, Side::Left);
      CHECK(a.s == b.s);
      CHECK((a.v == b.v || std::isnan(a.v)));
      CHECK((a.a == b.a || std::isnan(a.a)));
    }
    CHECK(text_of(read) == text_of(law));
  }
}

TEST_CASE("A law is known by its path, and in one's own folder by its name", "[law-files]") {
  const OwnFolder own;
  const Law<double> law = find_law("polynomial-5 alpha=-3").law();
  const std::string path = own.put("mine.json", text_of(law));
  CHECK(find_any_law(path).law()(0.3).s == law(0.3).s);
  CHECK(find_any_law("mine.json", own.folder()).family->name == "mine");
  CHECK(find_any_law("mine").law()(0.3).s == law(0.3).s);
  CHECK(find_any_law(" mine ").family->formula == "a title");
  CHECK(find_any_law("cosine").family == find_law("cosine").family);
  own.put("cosine.json", text_of(law));  // does not come before the catalogue's
  CHECK(find_any_law("cosine").family == find_law("cosine").family);
  REQUIRE(own_laws().size() == 2);
  CHECK(own_laws()[1].family->name == "mine");
  CHECK_THROWS_WITH(find_any_law("mind"), Contains("there is no law 'mind'"));
  CHECK_THROWS_WITH(find_any_law("Sinoide"), Contains("did you mean") && Contains("(cycloidal)"));
  CHECK(find_any_law("modifizierte Sinoide").family->name == "modified-sine");
  CHECK(find_any_law("Parabel").family->name == "parabolic");
  CHECK(find_any_law("einfache Sinoide").family->name == "cosine");
  unsetenv(kOwnLaws);
  CHECK_THROWS_WITH(find_any_law("mine"), Contains("there is no law 'mine'"));
  CHECK(own_laws().empty());
  setenv(kOwnLaws, (own.folder() + "/none").c_str(), 1);
  CHECK_THROWS_WITH(own_laws(), Contains("CAMLAW_LAWS") && Contains("none"));
}

TEST_CASE("A law of the catalogue with arguments is no path", "[law-files]") {
  const OwnFolder own;
  CHECK_THROWS_WITH(find_any_law("cosine crossover=1/3"),
                    Contains("parameter crossover: '1/3' is not a number"));
  CHECK_THROWS_WITH(find_any_law("cosine crossover = 1/3"), Contains("'1/3' is not a number"));
  CHECK_THROWS_WITH(find_any_law("modifizierte Sinoide crossover=1/3"),
                    Contains("'1/3' is not a number"));
  CHECK_THROWS_WITH(find_any_law("polynomial-5 alpha=-3/1"), Contains("'-3/1' is not a number"));
  CHECK_THROWS_WITH(find_any_law("cosine crossover=a.json"), Contains("'a.json' is not a number"));
  CHECK(law_file_of("cosine crossover=1/3").empty());
  // What begins with such a name and is a file's name stays one.
  own.put("cosine as run.json", text_of(find_law("cosine").law()));
  CHECK(is_law_file(find_any_law("cosine as run.json", own.folder())));
  own.put("a=b.json", text_of(find_law("cosine").law()));
  CHECK(is_law_file(find_any_law("a=b.json", own.folder())));
  CHECK(is_law_file(find_any_law(own.folder() + "/a=b.json")));
}

TEST_CASE("A list of a law may be empty wherever it stands", "[law-files]") {
  const Member last = find_law("b-spline degree=3 coefficients=0,0.1,0.9,1 knots=");
  for (const char* text : {"b-spline degree=3 knots= coefficients=0,0.1,0.9,1",
                           "b-spline knots= degree=3 coefficients=0, 0.1, 0.9, 1",
                           "b-spline knots =  degree = 3 coefficients = 0,0.1,0.9,1",
                           "b-spline degree= 3 knots=coefficients coefficients=0,0.1,0.9,1"}) {
    INFO(text);
    if (std::string(text).find("=coefficients") != std::string::npos) {
      CHECK_THROWS_WITH(find_law(text), Contains("'coefficients' is not a number"));
      continue;
    }
    const Member member = find_law(text);
    CHECK(member.name() == last.name());
    // Cubic Bernstein polynomials: s(1/3) = (12 * 0.1 + 6 * 0.9 + 1) / 27.
    CHECK(member.law()(1.0 / 3).s == Approx((12 * 0.1 + 6 * 0.9 + 1) / 27).epsilon(1e-14));
  }
  CHECK_THROWS_WITH(find_law("cosine crossover= "), Contains("'' is not a number"));
  CHECK_THROWS_WITH(find_law("scca a= b=0.2 c=0.1"), Contains("parameter a: '' is not a number"));
}

TEST_CASE("A problem file takes laws from files beside it", "[law-files]") {
  const OwnFolder own;
  own.put("mine.json", text_of(find_law("modified-sine").law()));
  const std::string file =
      own.put("problem.toml", "mechanism = 'law'\n[law]\nname = ['mine.json', 'cosine', 'mine']\n");
  CHECK_THROWS_WITH(read_problem_file(file), Contains("law.name") && Contains("appears twice"));
  const std::string good =
      own.put("problem.toml", "mechanism = 'law'\n[law]\nname = ['mine.json', 'cosine']\n");
  const auto problem = read_problem_file(good);
  CHECK(problem.laws.front().law()(0.2).s == find_law("modified-sine").law()(0.2).s);
  const std::string missing =
      own.put("problem.toml", "mechanism = 'law'\n[law]\nname = 'other.json'\n");
  CHECK_THROWS_WITH(read_problem_file(missing),
                    Contains("problem.toml:3: law.name") && Contains("other.json"));
}

TEST_CASE("Files of one name are told apart by their paths, and by what is in them",
          "[law-files]") {
  const OwnFolder own;
  fs::create_directory(own.folder() + "/a");
  fs::create_directory(own.folder() + "/b");
  own.put("a/law.json", text_of(find_law("cycloidal").law()));
  own.put("b/law.json", text_of(find_law("modified-sine").law()));
  own.put("other.json", text_of(find_law("modified-sine").law()));
  own.put("cosine.json", text_of(find_law("modified-sine").law()));
  const auto laws = [&](const std::string& names) {
    std::vector<std::string> result;
    for (const Member& law : read_problem("mechanism = 'law'\n[law]\nname = [" + names + "]\n",
                                          own.folder() + "/p.toml")
                                 .laws) {
      result.push_back(law.label());
    }
    return result;
  };
  using Names = std::vector<std::string>;
  CHECK(laws("'a/law.json', 'b/law.json'") == Names{"a/law.json", "b/law.json"});
  CHECK(laws("'a/law.json', 'cosine'") == Names{"law", "cosine"});
  CHECK(laws("'cosine.json', 'cosine'") == Names{"cosine.json", "cosine"});
  CHECK_THROWS_WITH(laws("'b/law.json', 'other.json'"), Contains("'other' appears twice"));
  CHECK_THROWS_WITH(laws("'b/law.json', './b/law.json'"), Contains("appears twice"));
}

TEST_CASE("A file that is called free is not the free law", "[law-files]") {
  const OwnFolder own;
  own.put("free.json", text_of(find_law("cycloidal").law()));
  const std::string named = "mechanism = 'law'\n[law]\nname = 'free.json'\n";
  const auto read = [&](const std::string& text) {
    return read_problem(text, own.folder() + "/p.toml");
  };
  CHECK(read(named).variables.empty());
  CHECK_THROWS_WITH(read(named + "[free]\nknots = 4\n"), Contains("no law of the problem is free"));
}

TEST_CASE("Damaged and foreign files are refused with what is wrong", "[law-files]") {
  const OwnFolder own;
  const Json good = law_file(find_law("modified-sine").law(), "t", Json{});
  const auto complaint = [&](const std::string& text) -> std::string {
    const std::string path = own.put("bad.json", text);
    try {
      read_law_file(path);
      return "accepted";
    } catch (const std::invalid_argument& error) {
      const std::string message = error.what();
      CHECK(message.starts_with(path + ": "));
      CHECK(message.find('\n') == std::string::npos);
      return message;
    }
  };
  const auto changed = [&](const auto& change) {
    Json file = good;
    change(file);
    return complaint(file.dump());
  };
  CHECK(complaint(good.dump()) == "accepted");
  CHECK_THAT(complaint(""), Contains("not valid JSON"));
  CHECK_THAT(complaint(good.dump().substr(0, 300)), Contains("not valid JSON"));
  CHECK_THAT(complaint("[1, 2]"), Contains("not a law file"));
  CHECK_THAT(complaint("{\"pieces\": []}"), Contains("not a law file"));
  CHECK_THAT(changed([](Json& f) { f["format"] = "camlaw law 2"; }),
             Contains("newer than this program"));
  CHECK_THAT(changed([](Json& f) { f["format"] = "camlaw cam 1"; }),
             Contains("it must be 'camlaw law 1'"));
  CHECK_THAT(changed([](Json& f) { f["format"] = 1; }), Contains("not a law file"));
  CHECK_THAT(changed([](Json& f) { f.erase("title"); }), Contains("it has no title"));
  CHECK_THAT(changed([](Json& f) { f.erase("pieces"); }), Contains("it has no pieces"));
  CHECK_THAT(changed([](Json& f) { f["ends"] = "R-X"; }), Contains("ends 'R-X'"));
  CHECK_THAT(changed([](Json& f) { f["ends"] = 3; }), Contains("ends is not text"));
  CHECK_THAT(changed([](Json& f) { f["pieces"] = 3; }), Contains("pieces is not a list"));
  CHECK_THAT(changed([](Json& f) { f["pieces"] = Json::array(); }), Contains("no pieces"));
  CHECK_THAT(changed([](Json& f) { f["pieces"][1].erase("origin"); }),
             Contains("pieces[2] has no origin"));
  CHECK_THAT(changed([](Json& f) { f["pieces"][0]["polynomial"][0] = nullptr; }),
             Contains("pieces[1].polynomial[1] is not a number"));
  CHECK_THAT(changed([](Json& f) { f["pieces"][0]["harmonics"][0].erase("sine"); }),
             Contains("pieces[1].harmonics[1] has no sine"));
  CHECK_THAT(changed([](Json& f) { f["pieces"][0]["end"] = 0.2; }), Contains("does not meet"));
  CHECK_THAT(changed([](Json& f) { f["pieces"].erase(2); }), Contains("does not meet"));
  CHECK_THAT(changed([](Json& f) { f["pieces"][2]["polynomial"][0] = 7; }),
             Contains("the displacement jumps at"));
  CHECK_THAT(changed([](Json& f) {
               for (Json& piece : f["pieces"]) {
                 piece["polynomial"][0] = piece["polynomial"][0].get<double>() + 0.5;
               }
             }),
             Contains("go from 0.5 to 1.5, not from 0 to 1"));
  CHECK_THAT(changed([](Json& f) {
               f["pieces"][0]["curves"] = {
                   {{"curve", "spiral"}, {"amplitude", 1}, {"rate", 1}, {"shift", 0}}};
             }),
             Contains("pieces[1].curves[1].curve must be half-ellipse"));
  CHECK_THAT(
      changed([](Json& f) { f["pieces"][0]["polynomial"] = std::vector<double>(3002, 0.0); }),
      Contains("pieces[1].polynomial has 3002 terms; at most 101"));
  CHECK_THAT(changed([](Json& f) { f["pieces"][0]["harmonics"][0]["frequency"] = 1e300; }),
             Contains("pieces[1].harmonics[1].frequency = 1e+300 is outside"));
  for (const char* curve :
       {"{\"curve\": \"inclined-sine\", \"e\": 5}", "{\"curve\": \"ellipse\", \"n\": 0}",
        "{\"curve\": \"power\", \"exponent\": 1e9}"}) {
    CHECK_THAT(changed([&](Json& f) {
                 Json term = Json::parse(curve);
                 term["amplitude"] = 1, term["rate"] = 1, term["shift"] = 0;
                 f["pieces"][0]["curves"] = Json::array({term});
               }),
               Contains("is outside"));
  }
  CHECK_THAT(changed([](Json& f) { f["title"] = "a\n\x1b[2Jb"; }), Contains("control characters"));
  CHECK_THROWS_WITH(read_law_file(own.folder()), Contains("it is a directory, not a law file"));
  CHECK_THROWS_WITH(read_law_file(own.folder() + "/no.json"), Contains("cannot be read"));
}

}  // namespace camlaw::problems::law_file_test
