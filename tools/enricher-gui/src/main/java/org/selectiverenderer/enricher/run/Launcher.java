package org.selectiverenderer.enricher.run;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.selectiverenderer.base.machine.ParentProcess;
import org.selectiverenderer.base.machine.ProgramCommand;

/** Starts commands of the program in processes of their own. */
public final class Launcher {
  /** By its name: the command line uses the enricher, not the other way round. */
  static final String MAIN = "org.selectiverenderer.cli.Main";

  private Launcher() {}

  /**
   * Starts a command whose messages are to be read. A {@code run} ends with this process; others do
   * not look.
   */
  static Process start(List<String> words) throws IOException {
    return new ProcessBuilder(ProgramCommand.of(MAIN, List.of(ParentProcess.flag()), words))
        .redirectErrorStream(true)
        .start();
  }

  /**
   * Opens a scene in an enricher of its own, which goes on when this one ends.
   *
   * @throws IOException if it cannot be started
   */
  public static void enrich(Path scene) throws IOException {
    new ProcessBuilder(ProgramCommand.of(MAIN, List.of(), List.of("enrich", scene.toString())))
        .redirectErrorStream(true)
        .redirectOutput(ProcessBuilder.Redirect.DISCARD)
        .start();
  }
}
