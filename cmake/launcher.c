// SPDX-License-Identifier: MIT
// The front door of the portable folder, linked statically, so that it needs nothing of the system.
// PREFIX/bin/NAME, or PREFIX/libexec/camlaw/NAME, runs PREFIX/lib/camlaw/NAME by the dynamic linker
// and the libraries that lie beside it.
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

// Cuts the last part of a path off; what is cut off.
static char* cut(char* path) {
  char* slash = strrchr(path, '/');
  if (slash == NULL) return path;
  *slash = 0;
  return slash + 1;
}

static void join(char* result, const char* folder, const char* name) {
  if (snprintf(result, PATH_MAX, "%s/%s", folder, name) < PATH_MAX) return;
  fputs("camlaw: the path of the program is too long\n", stderr);
  exit(1);
}

int main(int argc, char** argv) {
  char prefix[PATH_MAX], name[NAME_MAX + 1], linker[PATH_MAX], libraries[PATH_MAX];
  char program[PATH_MAX], units[PATH_MAX];
  const ssize_t length = readlink("/proc/self/exe", prefix, sizeof prefix - 1);
  if (length <= 0) {
    fputs("camlaw: /proc is needed, to find the program's files\n", stderr);
    return 1;
  }
  prefix[length] = 0;
  snprintf(name, sizeof name, "%s", cut(prefix));
  if (strcmp(cut(prefix), "camlaw") == 0) cut(prefix);  // libexec/camlaw, else bin

  join(libraries, prefix, "lib");
  join(linker, libraries, "ld-linux-x86-64.so.2");
  join(program, libraries, "camlaw/");
  strncat(program, name, sizeof program - strlen(program) - 1);
  join(units, prefix, "share/udunits/udunits2.xml");
  setenv("UDUNITS2_XML_PATH", units, 0);

  char** arguments = calloc((size_t)argc + 8, sizeof *arguments);
  if (arguments == NULL) return 1;
  int n = 0;
  arguments[n++] = linker;
  arguments[n++] = "--inhibit-cache";
  arguments[n++] = "--library-path";
  arguments[n++] = libraries;
  arguments[n++] = "--argv0";
  arguments[n++] = argv[0];
  arguments[n++] = program;
  for (int i = 1; i < argc; ++i) arguments[n++] = argv[i];
  execv(linker, arguments);
  perror("camlaw: the program cannot be started");
  return 1;
}
