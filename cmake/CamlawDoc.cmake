# The target doc: the API's reference by Doxygen, where that is installed. Warnings are errors.

find_program(DOXYGEN_PROGRAM doxygen)
configure_file(docs/Doxyfile.in ${PROJECT_BINARY_DIR}/Doxyfile @ONLY)
if(DOXYGEN_PROGRAM)
  add_custom_target(doc COMMAND ${DOXYGEN_PROGRAM} ${PROJECT_BINARY_DIR}/Doxyfile
    COMMENT "The API's reference: ${PROJECT_BINARY_DIR}/doc/html/index.html")
endif()
