// SPDX-License-Identifier: MIT
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "machines/registry.h"
#include "tests/paths.h"
#include "tests/temporary_folder.h"

/// The rules that docs/design.md, "Rooms", states of the house, read from its sources.
namespace camlaw::architecture_test {
namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;

/// The libraries and the program, the lowest first, each with those that it may include.
const std::map<std::string, Names>& rooms() {
  static const std::map<std::string, Names> known = [] {
    std::map<std::string, Names> all{{"numerics", {}},
                                     {"kinematics", {"numerics"}},
                                     {"optim", {"numerics"}},
                                     {"machines", {"numerics", "kinematics", "optim"}}};
    Names below{"numerics", "kinematics", "optim", "machines"};
    for (const char* room : {"problems", "fitting", "output", "cli"}) {
      all[room] = below;
      below.insert(room);
    }
    all["python"] = all["cli"];  // the package for Python is beside the program
    return all;
  }();
  return known;
}

/// Who may include headers of these libraries: files, or folders that end in a slash.
const std::map<std::string, Names>& libraries() {
  static const std::map<std::string, Names> known{
      {"CLI/", {"cli/command_line.cpp", "cli/version_text.cpp"}},
      {"toml++/", {"problems/statement/toml_entry.cpp"}},
      {"nlohmann/",
       {"problems/law_files/json_text.h", "problems/law_files/json_type.h", "cli/version_text.cpp",
        "optim/crew/bytes.cpp"}},
      {"udunits", {"numerics/text/units.cpp"}},
      {"Ip",
       {"optim/solvers/ipopt.cpp", "optim/solvers/ipopt_options.cpp",
        "optim/solvers/ipopt_options.h"}},
      {"Clp", {"optim/solvers/clp.cpp", "optim/solvers/small_program.cpp"}},
      {"Coin", {"optim/solvers/clp.cpp", "optim/solvers/small_program.cpp"}},
      {"nlopt", {"optim/solvers/nlopt_methods.h"}},
      {"nanobind/", {"python/bindings/"}},
      {"mpi.h", {"optim/crew/mpi_plugin.cpp"}},
      {"pagmo/", {"optim/pareto/nsga2_plugin.cpp"}},
      {"SQLite", {"optim/study/"}},
      // Open CASCADE, by what its headers' names begin with.
      {"BRep",
       {"output/export/solid/step_barrel.cpp", "output/export/solid/step_plugin.cpp",
        "output/export/solid/step_prism.cpp"}},
      {"Geom", {"output/export/solid/step_barrel.cpp", "output/export/solid/step_prism.cpp"}},
      {"STEPControl_", {"output/export/solid/step_plugin.cpp"}},
      {"TopoDS",
       {"output/export/solid/step_barrel.cpp", "output/export/solid/step_barrel.h",
        "output/export/solid/step_plugin.cpp", "output/export/solid/step_prism.cpp",
        "output/export/solid/step_prism.h"}},
      // Matrices are everywhere; what factors them takes seconds to compile in each unit.
      {"Eigen/Dense", {}},
      {"Eigen/Cholesky", {"numerics/linear/dense.cpp", "numerics/linear/normal_equations.cpp"}},
      {"Eigen/Eigenvalues", {"numerics/linear/dense.cpp", "numerics/linear/power_method.cpp"}},
      {"Eigen/LU", {"numerics/linear/dense.cpp"}},
      {"Eigen/QR", {"numerics/linear/dense.cpp"}},
      {"Eigen/SVD", {"numerics/linear/dense.cpp"}},
      {"Eigen/SparseCholesky",
       {"numerics/linear/normal_equations.cpp", "optim/verdict/second_order.cpp"}},
      {"Eigen/SparseLU", {"kinematics/laws/spline.cpp"}},
      {"boost/multiprecision/", {"kinematics/laws/polynomial.cpp"}},
      {"boost/math/quadrature/gauss.hpp", {"numerics/polynomial/gauss_legendre.cpp"}},
      {"ceres/",
       {"numerics/scalar/dual.h", "optim/fit/ceres_search.cpp", "optim/problem/automatic.h"}}};
  return known;
}

/// Who may catch std::invalid_argument: files, or folders that end in a slash. What a search or a
/// fit runs into is a Possible (docs/design.md, "Errors").
const Names& refusals_caught() {
  static const Names known{
      // A text may be read in several ways, or its place is added to the sentence.
      "numerics/formula/formula_writer.cpp", "numerics/tables/column_names.cpp",
      "numerics/tables/columns.cpp", "machines/model/formula_names.cpp",
      "problems/fronts/problem_settings.cpp", "problems/law_files/law_file.cpp",
      "problems/results/recorded_design.cpp", "problems/results/start_settings.cpp",
      "problems/statement/catalogue_rows.cpp", "problems/statement/program_units.cpp",
      "problems/statement/read_program.cpp", "problems/statement/read_responses.cpp",
      "problems/statement/read_table.cpp", "problems/statement/table_settings.cpp",
      "problems/statement/toml_reader.cpp", "problems/statement/toml_reader.h",
      "fitting/cams/measured_cam.cpp", "fitting/constants/printed_constants.cpp",
      "problems/tolerance/varied_design.cpp",
      // A curve that was not asked for has no point somewhere: the others are looked at.
      "output/answers/cam_export.cpp",
      // A design whose profile no follower can follow has all the rest of its page.
      "output/report/problem_sections.cpp",
      // Of a combination of a sweep it is the outcome: why that combination has no design.
      "problems/sweeps/sweep_study.cpp",
      // Values whose units do not go together are words.
      "problems/sweeps/axis.cpp",
      // It becomes an exit status, a sentence with the file's name, an exception of Python.
      "cli/", "python/bindings/errors.cpp", "python/bindings/fits.cpp",
      // A warning is left out where the problem is refused anyway by whoever searches or evaluates.
      "output/answers/warnings.cpp", "problems/statement/doubtful_limits.cpp"};
  return known;
}

struct Include {
  std::string from, to;  ///< files, from the root
  bool is_own;           ///< in quotes
};

std::string folder_of(const std::string& file) { return file.substr(0, file.rfind('/')); }
std::string room_of(const std::string& file) { return file.substr(0, file.find('/')); }

/// The sources of a folder, from the root.
std::vector<std::string> sources_of(const std::string& folder) {
  std::vector<std::string> files;
  const fs::path root = testing::source();
  for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
    const std::string extension = entry.path().extension().string();
    if (extension == ".h" || extension == ".cpp") {
      files.push_back(fs::relative(entry.path(), root).string());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// The sources of the rooms.
std::vector<std::string> sources() {
  std::vector<std::string> files;
  for (const auto& [room, below] : rooms()) {
    for (std::string& file : sources_of(room)) files.push_back(std::move(file));
  }
  return files;
}

std::vector<Include> includes_of(const std::vector<std::string>& files) {
  static const std::regex line(R"(#include ([<"])([^>"]+)[>"])");
  std::vector<Include> all;
  for (const std::string& file : files) {
    const std::string text = testing::read(fs::path(testing::source()) / file);
    for (std::sregex_iterator i(text.begin(), text.end(), line), end; i != end; ++i) {
      all.push_back({file, (*i)[2], (*i)[1] == "\""});
    }
  }
  return all;
}

std::vector<Include> includes() { return includes_of(sources()); }

/// The words of a file, without brackets.
Names words_of(const fs::path& file) {
  static const std::regex word(R"([^\s()]+)");
  const std::string text = testing::read(file);
  Names words;
  for (std::sregex_iterator i(text.begin(), text.end(), word), end; i != end; ++i) {
    words.insert(i->str());
  }
  return words;
}

/// Whether `goal` is reached from `folder` along the includes of folders.
bool reaches(const std::map<std::string, Names>& graph, const std::string& folder,
             const std::string& goal, Names& seen) {
  const auto next = graph.find(folder);
  if (next == graph.end() || !seen.insert(folder).second) return false;
  return next->second.count(goal) > 0 ||
         std::any_of(next->second.begin(), next->second.end(),
                     [&](const std::string& to) { return reaches(graph, to, goal, seen); });
}

bool allows(const Names& files, const std::string& file) {
  return std::any_of(files.begin(), files.end(), [&](const std::string& known) {
    return known == file || (known.back() == '/' && file.starts_with(known));
  });
}

TEST_CASE("rooms include only what lies below them", "[architecture]") {
  for (const Include& include : includes()) {
    const std::string from = room_of(include.from), to = room_of(include.to);
    if (!include.is_own || rooms().count(to) == 0 || from == to) continue;
    INFO(include.from << " includes " << include.to);
    CHECK(rooms().at(from).count(to) == 1);
  }
}

TEST_CASE("no folder includes itself by way of others", "[architecture]") {
  std::map<std::string, Names> graph;
  for (const Include& include : includes()) {
    const std::string from = folder_of(include.from), to = folder_of(include.to);
    if (include.is_own && rooms().count(room_of(include.to)) > 0 && from != to) {
      graph[from].insert(to);
    }
  }
  REQUIRE(graph.size() > 20);
  for (const auto& [folder, next] : graph) {
    Names seen;
    INFO(folder);
    CHECK_FALSE(reaches(graph, folder, folder, seen));
  }
}

TEST_CASE("each library's headers are included where the list says", "[architecture]") {
  Names unused;
  for (const auto& [library, files] : libraries()) {
    for (const std::string& file : files) unused.insert(library + " in " + file);
  }
  for (const Include& include : includes()) {
    for (const auto& [library, files] : libraries()) {
      if (!include.to.starts_with(library)) continue;
      INFO(include.from << " includes " << include.to);
      CHECK(allows(files, include.from));
      std::erase_if(unused, [&](const std::string& entry) {
        return entry.starts_with(library + " in ") &&
               include.from.starts_with(entry.substr(library.size() + 4));
      });
    }
  }
  CHECK(unused == Names{});
}

TEST_CASE("a refusal is caught where the list says", "[architecture]") {
  Names unused = refusals_caught();
  for (const std::string& file : sources()) {
    const std::string text = testing::read(fs::path(testing::source()) / file);
    if (text.find("catch (const std::invalid_argument") == std::string::npos) continue;
    INFO(file << " catches std::invalid_argument");
    CHECK(allows(refusals_caught(), file));
    std::erase_if(unused, [&](const std::string& known) { return allows({known}, file); });
  }
  CHECK(unused == Names{});
}

TEST_CASE("no machine is told by its name but where files and people name it", "[architecture]") {
  // A machine's Form says how it is built. What is found by name, or printed, is another matter.
  static const std::regex named("\"([a-z-]+)\"");
  static const std::regex compared(R"((==|!=|starts_with|ends_with))");
  Names machines;
  for (const problems::Mechanism& machine : problems::mechanisms()) machines.insert(machine.name);
  REQUIRE(machines.size() > 20);
  for (const std::string& file : sources()) {
    std::istringstream text(testing::read(fs::path(testing::source()) / file));
    for (std::string line; std::getline(text, line);) {
      if (!std::regex_search(line, compared) || line.find("name") == std::string::npos) continue;
      for (std::sregex_iterator i(line.begin(), line.end(), named), end; i != end; ++i) {
        const std::string word = (*i)[1];
        const bool begins = std::any_of(machines.begin(), machines.end(), [&](const auto& name) {
          return name == word || (word.size() > 4 && name.find(word) != std::string::npos);
        });
        INFO(file << ": " << line);
        CHECK_FALSE(begins);
      }
    }
  }
}

TEST_CASE("no parameter or response is told by its name outside the machines", "[architecture]") {
  // What a name alone says stands in machines/model/known_names.h; the rest is looked up by name.
  static const std::regex compared(
      R"re([=!]=\s*"([a-z0-9_]+)"|"([a-z0-9_]+)"\s*[=!]=|)re"
      R"re((?:starts_with|ends_with|find|contains)\("_?([a-z0-9_]+)"\))re");
  // A word of problem files, as which a program's segments are matched.
  static const std::map<std::string, Names> words{
      {"problems/statement/read_program.cpp", {"displacement", "velocity", "acceleration"}}};
  Names named;
  for (const problems::Mechanism& machine : problems::mechanisms()) {
    for (const auto& parameter : machine.parameters) named.insert(parameter.name);
    for (const auto& response : machine.responses) named.insert(response.name);
    for (const auto& peak : machine.peaks) named.insert(peak.name);
  }
  REQUIRE(named.size() > 400);
  const auto comparisons_in = [&](const std::string& text) {
    Names found;
    for (std::sregex_iterator i(text.begin(), text.end(), compared), end; i != end; ++i) {
      const std::string word = (*i)[1].str() + (*i)[2].str() + (*i)[3].str();
      if (named.contains(word)) found.insert(word);
    }
    return found;
  };
  CHECK(comparisons_in("if (p.name != \"face_width\" || \"offset\" == name)") ==
        Names{"face_width", "offset"});
  CHECK(comparisons_in("name.find(\"jerk\"), name.ends_with(\"_displacement\")") ==
        Names{"jerk", "displacement"});
  for (const std::string& file : sources()) {
    if (file.starts_with("machines/")) continue;
    Names found = comparisons_in(testing::read(fs::path(testing::source()) / file));
    if (const auto known = words.find(file); known != words.end()) {
      for (const std::string& word : known->second) found.erase(word);
    }
    INFO(file);
    CHECK(found == Names{});
  }
}

/// The headers that cmake/CamlawHeaders.cmake installs.
Names installed_headers() {
  Names headers;
  for (const std::string& word :
       words_of(fs::path(testing::source()) / "cmake/CamlawHeaders.cmake")) {
    if (word.ends_with(".h") && word.find('/') != std::string::npos) headers.insert(word);
  }
  return headers;
}

/// The headers of other libraries that installed ones include, and which do.
const std::map<std::string, Names>& let_through() {
  static const std::map<std::string, Names> known{
      {"boost/numeric/interval.hpp", {"numerics/scalar/interval.h"}},
      {"ceres/jet.h", {"numerics/scalar/dual.h", "optim/problem/automatic.h"}}};
  return known;
}

TEST_CASE("installed headers are few, short and light", "[architecture]") {
  const Names headers = installed_headers();
  CHECK(headers.size() <= 45);
  REQUIRE(headers.size() > 20);
  for (const std::string& header : headers) {
    INFO(header);
    const std::string text = testing::read(fs::path(testing::source()) / header);
    CHECK(std::count(text.begin(), text.end(), '\n') <= 400);
  }
  for (const Include& include : includes_of({headers.begin(), headers.end()})) {
    INFO(include.from << " includes " << include.to);
    if (include.is_own) {
      CHECK(headers.count(include.to) == 1);
    } else if (include.to.find_first_of("/.") != std::string::npos) {
      const auto known = let_through().find(include.to);
      CHECK((known != let_through().end() && known->second.count(include.from) == 1));
    }
  }
}

TEST_CASE("who asks for dual numbers alone gets Ceres, and Eigen with it", "[architecture]") {
  // Of the installed headers: the number itself, and formulas that are derived by it.
  const Names dual{"numerics/scalar/dual.h", "optim/problem/automatic.h", "optim/fit/residuals.h"};
  std::map<std::string, Names> graph;
  const Names headers = installed_headers();
  for (const Include& include : includes_of({headers.begin(), headers.end()})) {
    graph[include.from].insert(include.to);
  }
  for (const std::string& header : headers) {
    Names seen;
    INFO(header);
    CHECK(reaches(graph, header, "ceres/jet.h", seen) == (dual.count(header) == 1));
  }
}

/// A type or a constant that stands in a namespace, not in a class or a function.
struct Declared {
  std::string file, scope, text;  ///< scope: the namespace's name; text: the line that declares it
  bool is_own;                    ///< in an unnamed namespace, for its source alone
  bool is_template;
};

/// The types and constants of a file by their names. What clang-format lets begin a line without
/// indentation stands in a namespace.
std::multimap<std::string, Declared> declared_in(const std::string& file) {
  static const std::regex space(R"(^namespace ?([\w:]*) \{)"), end_of_space(R"(^\}  // namespace)");
  static const std::regex type(R"(^(?:struct|class|enum class|enum|concept) (\w+)\b(?!<)(?!.*;))");
  static const std::regex alias(R"(^using (\w+) =)");
  static const std::regex constant(
      R"(^(?:inline |static )?constexpr [^(=]*?\b(\w+)(?:\[\])?(?: =|\{))");
  std::multimap<std::string, Declared> all;
  std::vector<std::string> spaces;
  std::string before;
  std::istringstream text(testing::read(fs::path(testing::source()) / file));
  for (std::string line; std::getline(text, line); before = line) {
    std::smatch found;
    if (std::regex_search(line, found, space)) spaces.push_back(found[1]);
    if (std::regex_search(line, end_of_space) && !spaces.empty()) spaces.pop_back();
    if (std::regex_search(line, found, type) || std::regex_search(line, found, alias) ||
        std::regex_search(line, found, constant)) {
      Declared one{file, {}, line, false, before.starts_with("template")};
      for (const std::string& name : spaces) {
        if (name.empty()) one.is_own = true;
        one.scope += "::" + name;
      }
      while (one.scope.ends_with("::")) one.scope.resize(one.scope.size() - 2);
      all.emplace(found[1], one);
    }
  }
  return all;
}

TEST_CASE("what a source keeps to itself has a name of its own in its room", "[architecture]") {
  // Sources of a room form units that the compiler sees as one, in groups that a new file or
  // another preset forms anew. Aliases of the same text may stand in several.
  for (const auto& [room, below] : rooms()) {
    std::multimap<std::string, Declared> all;
    for (const std::string& file : sources_of(room)) all.merge(declared_in(file));
    for (const auto& [name, own] : all) {
      // What follows a template's parameters, "using S = ..." among them, hides nothing of another.
      if (!own.is_own || own.is_template) continue;
      const auto [first, last] = all.equal_range(name);
      for (auto other = first; other != last; ++other) {
        if (other->second.file == own.file || other->second.scope != own.scope) continue;
        if (other->second.is_template) continue;
        INFO(own.file << " and " << other->second.file << " name " << name);
        CHECK((own.text.starts_with("using ") && other->second.text == own.text));
      }
    }
  }
}

/// Whether a file's path is what CMakeLists.txt names, or what one of its patterns finds: "*.cpp"
/// in the room's own folder, "folder/*_end.cpp" in another.
bool matches(const std::string& named, const std::string& path) {
  const auto star = named.find('*');
  if (star == named.npos) return named == path;
  const std::string begin = named.substr(0, star), end = named.substr(star + 1);
  return path.size() >= begin.size() + end.size() && path.starts_with(begin) &&
         path.ends_with(end) && path.find('/', begin.size()) == path.npos;
}

TEST_CASE("no two headers have a type of one name", "[architecture]") {
  // One word is one type (docs/glossary.md), in whichever namespace it stands. Documents have the
  // JSON of law files under the same name in their own namespace.
  const Names same{"Json"};
  std::map<std::string, std::string> known;
  for (const std::string& file : sources()) {
    if (!file.ends_with(".h")) continue;
    for (const auto& [name, type] : declared_in(file)) {
      if (type.is_own || type.text.find("constexpr") != std::string::npos) continue;
      const auto [at, is_new] = known.emplace(name, file);
      INFO(at->second << " and " << file << " name " << name);
      CHECK((is_new || at->second == file || same.contains(name)));
    }
  }
  REQUIRE(known.size() > 500);
}

TEST_CASE("every source is compiled, every header is included somewhere", "[architecture]") {
  const fs::path root = testing::source();
  std::vector<std::string> files = sources();
  for (const char* folder : {"tests", "examples", "benchmarks"}) {
    for (std::string& file : sources_of(folder)) files.push_back(std::move(file));
  }
  Names included;
  for (const Include& include : includes_of(files)) {
    if (include.is_own) included.insert(include.to);
  }
  for (const std::string& file : sources()) {
    INFO(file);
    const std::string room = room_of(file), path = file.substr(room.size() + 1);
    if (file.ends_with(".cpp")) {
      const Names words = words_of(root / room / "CMakeLists.txt");
      CHECK(std::any_of(words.begin(), words.end(),
                        [&](const std::string& word) { return matches(word, path); }));
    } else {
      CHECK(included.count(file) == 1);
    }
  }
}

}  // namespace
}  // namespace camlaw::architecture_test
