package org.selectiverenderer.runtime.loading;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.x3d.files.ContentRoot;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.script.Program;
import org.selectiverenderer.x3d.script.ProgramChoice;

/** Reads the programs of Scripts. */
final class ScriptFiles {
  /** Bytes of a program's file, far more than anybody writes. */
  private static final int MAX_BYTES = 4 << 20;

  private final ContentRoot root;

  ScriptFiles(ContentRoot root) {
    this.root = root;
  }

  /**
   * The program of a Script; empty, with a message, when it has none that can be used.
   *
   * @param folder of the file that holds the Script
   */
  Optional<Program> read(ParsedNode script, Path folder, Problems problems) {
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

  private Optional<Program> fromFile(ParsedNode script, Path path, Problems problems) {
    String name = root.display(path);
    try (InputStream in = Files.newInputStream(path)) {
      byte[] bytes = in.readNBytes(MAX_BYTES + 1);
      if (bytes.length <= MAX_BYTES) {
        String text = new String(bytes, StandardCharsets.UTF_8);
        return Optional.of(new Program(text, new Location(name, 1, 1)));
      }
      problems.error(
          script.location(),
          "%s has more than %s MB, the limit of a program; the Script does nothing"
              .formatted(name, MAX_BYTES >> 20));
    } catch (IOException e) {
      problems.error(
          script.location(), "%s %s; the Script does nothing".formatted(name, Failure.clause(e)));
    }
    return Optional.empty();
  }
}
