#include "tests/x11/support/malformed_files.h"

#include "tests/x11/support/command_fixture.h"

namespace xnewell::THIS_FILE {

// Each malformed file is refused in one line with the file and what is wrong, with the place where there is
// one, and the status of the table. Nothing is written. Sizes that a file only promises take neither time nor
// memory.
TEST_F(CommandTest, MalformedFilesAreRefused) {
  for (const Malformed& row : malformedFiles()) {
    const std::string wrong = write(row.name, row.content);
    SCOPED_TRACE(row.content.substr(0, 300));
    const bool library = row.name.ends_with(".mtl"), lesson = row.name == "l.json";
    const std::string scene =
        library ? write("of_mtl.obj", "mtllib " + row.name + "\nusemtl m\n" + kTriangleObj) : wrong;
    refused(lesson ? Strings{"lesson", wrong, "--frames", file("frames")}
                   : Strings{"draw", scene, "-o", file("new.png")},
            row.status, wrong + row.message);
  }
}

}  // namespace xnewell::THIS_FILE
