#pragma once
#include <sys/wait.h>

#include <cstdlib>
#include <string>

#include "tests/support/scratch.hpp"

/// The program as a user runs it. Needs  VICUS_PROGRAM, its path, defined by tests/CMakeLists.txt.
namespace vicus::test {

/// `vicus ARGUMENTS`: exit code, stdout and stderr.
struct Outcome {
  int rc = -1;
  std::string out, errors;
};

inline Outcome vicus_program(const ScratchDirectory& scratch, const std::string& arguments) {
  const std::string out = (scratch / "out").string(), errors = (scratch / "err").string();
  const int status = std::system((VICUS_PROGRAM " " + arguments + " >'" + out + "' 2>'" + errors + "'").c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_bytes(out), read_bytes(errors)};
}

}  // namespace vicus::test
