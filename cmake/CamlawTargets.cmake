# What every target of the project shares: language level, warnings, include root.

function(camlaw_options target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>)
  target_compile_options(${target} PRIVATE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wdouble-promotion
    -Woverloaded-virtual -Wnon-virtual-dtor -Wold-style-cast -Wimplicit-fallthrough
    $<$<BOOL:${CAMLAW_WERROR}>:-Werror>)
endfunction()

function(camlaw_library name)
  add_library(camlaw_${name} STATIC ${ARGN})
  add_library(camlaw::${name} ALIAS camlaw_${name})
  camlaw_options(camlaw_${name})
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
