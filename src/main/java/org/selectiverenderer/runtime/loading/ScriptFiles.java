package org.selectiverenderer.runtime.loading;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.x3d.files.ContentRoot;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.script.ProgramChoice;
import org.selectiverenderer.x3d.script.ScriptProgram;

/** Reads the programs of Scripts. */
final class ScriptFiles {
  private final ContentRoot root;

  ScriptFiles(ContentRoot root) {
    this.root = root;
  }

  /**
   * The program of a Script; empty, with a message, when it has none that can be used.
   *
   * @param folder of the file that holds the Script
   */
  Optional<ScriptProgram> read(ParsedNode script, Path folder, Problems problems) {
    ProgramChoice choice = ProgramChoice.of(script, root, folder);
    if (choice instanceof ProgramChoice.Text text) {
      return Optional.of(text.program());
    }
    if (choice instanceof ProgramChoice.File file) {
      return fromFile(script, file.path(), problems);
    }
    problems.add(((ProgramChoice.None) choice).problem());
    return Optional.empty();
  }

  private Optional<ScriptProgram> fromFile(ParsedNode script, Path path, Problems problems) {
    String name = root.display(path);
    try {
      Optional<ScriptProgram> program = ScriptProgram.read(path, root);
      if (program.isPresent()) {
        return program;
      }
      problems.error(
          script.location(),
          "%s has more than %s MB, the limit of a program; the Script does nothing"
              .formatted(name, ScriptProgram.MAX_BYTES >> 20));
    } catch (IOException e) {
      problems.error(
          script.location(), "%s %s; the Script does nothing".formatted(name, Failure.clause(e)));
    }
    return Optional.empty();
  }
}
