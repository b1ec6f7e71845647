# What every target of the project shares: language level, warnings, include root.

# The libraries serve the program and the Python module alike, so that neither costs a second build.
set(CMAKE_POSITION_INDEPENDENT_CODE ON)

function(camlaw_options target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>)
  target_compile_options(${target} PRIVATE
    -fno-semantic-interposition  # functions of one source may be inlined, position-independent or not
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wdouble-promotion
    -Woverloaded-virtual -Wnon-virtual-dtor -Wold-style-cast -Wimplicit-fallthrough
    $<$<BOOL:${CAMLAW_WERROR}>:-Werror>)
endfunction()

# Compiles the sources as units of up to CAMLAW_UNITY files: most of a file's time goes into the headers
# and templates that its neighbours need too (benchmarks/README.md). Sources that follow LONG take longer
# by themselves: up to four of a folder form a unit, for in a large one the compiler inlines less;
# those of no folder are compiled alone.
function(camlaw_units target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" LONG)
  if(NOT CAMLAW_UNITY)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  # A class of one source may hold what that source alone names, though a unit includes it.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
  get_target_property(sources ${target} SOURCES)
  list(REMOVE_ITEM sources ${arg_LONG})
  camlaw_unit_groups(short ${CAMLAW_UNITY} ${sources})
  set(folders)
  foreach(source IN LISTS arg_LONG)
    get_filename_component(folder ${source} DIRECTORY)
    if(folder STREQUAL "")
      continue()
    endif()
    string(MAKE_C_IDENTIFIER ${folder} folder)
    list(APPEND long_${folder} ${source})
    list(APPEND folders ${folder})
  endforeach()
  list(REMOVE_DUPLICATES folders)
  foreach(folder IN LISTS folders)
    camlaw_unit_groups(${folder} 4 ${long_${folder}})
  endforeach()
endfunction()

# Divides sources, in their order, into as few groups of at most LARGEST as there can be, of even size.
function(camlaw_unit_groups name largest)
  list(LENGTH ARGN count)
  math(EXPR groups "(${count} + ${largest} - 1) / ${largest}")
  set(place 0)
  foreach(source IN LISTS ARGN)
    math(EXPR group "${place} * ${groups} / ${count}")
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${name}_${group})
    math(EXPR place "${place} + 1")
  endforeach()
endfunction()

# For targets that only word, draw and check what others work out: optimising them costs more compile
# time than it saves when they run.
function(camlaw_plain target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()

# For targets that work things out: -O3 inlines as much, and what else it does beyond this costs a
# quarter of the compile time and gains next to nothing (benchmarks/README.md).
function(camlaw_inlined target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1 -fstrict-aliasing
    -finline-functions -finline-small-functions -findirect-inlining -fpartial-inlining
    --param=max-inline-insns-auto=30 --param=early-inlining-insns=14>)
endfunction()

# For code that only checks others, where the libraries are sanitized: half of its compile time would
# go to the sanitizers.
function(camlaw_not_sanitized target)
  if(CMAKE_CXX_FLAGS MATCHES "-fsanitize=address")
    target_compile_options(${target} PRIVATE -fno-sanitize=all)
    # What GCC compiles with the sanitizer aligns matrices by its own hand: memory of one must be
    # freed as the other allocates it.
    target_compile_definitions(${target} PRIVATE CAMLAW_SANITIZED
      $<$<CXX_COMPILER_ID:GNU>:EIGEN_MALLOC_ALREADY_ALIGNED=0>)
  endif()
endfunction()

function(camlaw_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" LONG)
  add_library(camlaw_${name} STATIC ${arg_UNPARSED_ARGUMENTS} ${arg_LONG})
  add_library(camlaw::${name} ALIAS camlaw_${name})
  camlaw_options(camlaw_${name})
  camlaw_units(camlaw_${name} LONG ${arg_LONG})
endfunction()

# Adds loops that are compiled once for each instruction set: BASE runs everywhere, AVX2 and AVX512
# on the processors that have them. CHOICE is the source that settles which of them runs when the
# program runs. Each is compiled by itself, with flags that no other file must see.
function(camlaw_lanes target choice base avx2 avx512)
  set(loops ${base})
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64)$")
    list(APPEND loops ${avx2} ${avx512})
    set_source_files_properties(${avx2} PROPERTIES COMPILE_OPTIONS -mavx2)
    set_source_files_properties(${avx512} PROPERTIES COMPILE_OPTIONS -mavx512f)
    set_source_files_properties(${choice} PROPERTIES COMPILE_DEFINITIONS CAMLAW_X86)
  endif()
  target_sources(${target} PRIVATE ${loops})
  set_source_files_properties(${loops} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  set_property(SOURCE ${loops} APPEND PROPERTY COMPILE_OPTIONS
    -ffp-contract=off $<$<CONFIG:Release>:-O3>)
endfunction()

# Turns a data file into a string constant, so that the program needs no files beside it:
#   camlaw_embed(target file.csv variable) gives #include "<folder>/file.csv.h" with
#   inline constexpr std::string_view camlaw::data::variable; a file of the system, by its whole
#   path, is included by its name alone.
function(camlaw_embed target file variable)
  if(IS_ABSOLUTE ${file})
    set(source ${file})
    get_filename_component(from_root ${file} NAME)
  else()
    set(source ${CMAKE_CURRENT_SOURCE_DIR}/${file})
    file(RELATIVE_PATH from_root ${PROJECT_SOURCE_DIR} ${source})
  endif()
  set(header ${PROJECT_BINARY_DIR}/embedded/${from_root}.h)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${source})
  file(READ ${source} content)
  set(template ${PROJECT_SOURCE_DIR}/cmake/embedded.h.in)
  configure_file(${template} ${header} @ONLY)
  target_include_directories(${target} PRIVATE ${PROJECT_BINARY_DIR}/embedded)
endfunction()
