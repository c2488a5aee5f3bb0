package org.selectiverenderer.runtime.loading;

import java.io.IOException;
import java.util.Optional;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.x3d.files.Content;
import org.selectiverenderer.x3d.files.ContentBase;
import org.selectiverenderer.x3d.files.ContentRoot;
import org.selectiverenderer.x3d.files.Failure;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.script.ProgramChoice;
import org.selectiverenderer.x3d.script.ScriptProgram;

/** Loads the programs of Scripts. */
final class ScriptFiles {
  private final ContentRoot root;

  ScriptFiles(ContentRoot root) {
    this.root = root;
  }

  /**
   * Loads the program of a Script; empty, with a message, if it has no usable one.
   *
   * @param base the base of the Script's relative urls
   */
  Optional<ScriptProgram> read(ParsedNode script, ContentBase base, Problems problems) {
    ProgramChoice choice = ProgramChoice.of(script, root, base);
    if (choice instanceof ProgramChoice.Text text) {
      return Optional.of(text.program());
    }
    if (choice instanceof ProgramChoice.File file) {
      return fromFile(script, file.content(), problems);
    }
    problems.add(((ProgramChoice.None) choice).problem());
    return Optional.empty();
  }

  private static Optional<ScriptProgram> fromFile(
      ParsedNode script, Content file, Problems problems) {
    try {
      return Optional.of(ScriptProgram.read(file));
    } catch (IOException e) {
      problems.error(
          script.location(),
          "%s %s; the Script does nothing".formatted(file.name(), Failure.clause(e)));
      return Optional.empty();
    }
  }
}
