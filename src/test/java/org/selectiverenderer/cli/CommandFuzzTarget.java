package org.selectiverenderer.cli;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import org.selectiverenderer.testing.FuzzFile;

/** Whole commands on a scene: checked, walked through, counted, written anew. */
public final class CommandFuzzTarget {
  /** Recorded in a scene of the thesis; here it is the viewer's way through whatever comes. */
  private static final Path PATH = Path.of("scenes", "paths", "desk-visit.csv").toAbsolutePath();

  private CommandFuzzTarget() {}

  /** Runs the commands on one input. */
  public static void fuzzerTestOneInput(byte[] input) {
    FuzzFile.with(
        "scene.x3d",
        input,
        file -> {
          String scene = file.toString();
          for (List<String> command :
              List.of(
                  List.of("validate", scene),
                  List.of("simulate", "--rate", "2", "--path", PATH.toString(), scene),
                  List.of("polygons", scene))) {
            execute(command);
          }
        });
  }

  static void execute(List<String> command) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    ByteArrayOutputStream err = new ByteArrayOutputStream();
    int status =
        Main.execute(
            command.toArray(String[]::new),
            new PrintStream(out, true, StandardCharsets.UTF_8),
            new PrintStream(err, true, StandardCharsets.UTF_8));
    String messages = err.toString(StandardCharsets.UTF_8);
    if (status < 0 || status > 2 || messages.contains("please report")) {
      throw new AssertionError(command.get(0) + " ended with " + status + ": " + messages);
    }
  }
}
