package org.selectiverenderer.enricher.run;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.selectiverenderer.base.platform.ChildProcessCommand;
import org.selectiverenderer.base.platform.ParentProcessWatcher;

/** Starts commands of the program in processes of their own. */
public final class ProcessLauncher {
  /**
   * The main class, by name, as the command line depends on the enricher and not the other way
   * round.
   */
  static final String MAIN = "org.selectiverenderer.cli.Main";

  private ProcessLauncher() {}

  /**
   * Starts a command whose output the caller reads. A {@code run} watches this process and ends
   * with it; other commands do not.
   */
  static Process start(List<String> words) throws IOException {
    return new ProcessBuilder(
            ChildProcessCommand.of(MAIN, List.of(ParentProcessWatcher.flag()), words))
        .redirectErrorStream(true)
        .start();
  }

  /**
   * Opens a scene in a separate enricher process, which outlives this one.
   *
   * @throws IOException if it cannot be started
   */
  public static void enrich(Path scene) throws IOException {
    launch(List.of("enrich", scene.toString()));
  }

  /**
   * Opens the study window in a separate process, which outlives this one.
   *
   * @throws IOException if it cannot be started
   */
  public static void studies() throws IOException {
    launch(List.of("experiment"));
  }

  private static void launch(List<String> words) throws IOException {
    new ProcessBuilder(ChildProcessCommand.of(MAIN, List.of(), words))
        .redirectErrorStream(true)
        .redirectOutput(ProcessBuilder.Redirect.DISCARD)
        .start();
  }
}
