package org.selectiverenderer.cli.author;

import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.selectiverenderer.cli.Main;
import org.selectiverenderer.testing.Eventually;

/**
 * A process that computes light as the command {@code radiosity} does, and stops at the first
 * message that contains a text until it is cancelled. Arguments are that text and the command's.
 */
final class PausingRadiosity {
  private PausingRadiosity() {}

  public static void main(String[] arguments) {
    List<String> command = new ArrayList<>(List.of("radiosity"));
    command.addAll(Arrays.asList(arguments).subList(1, arguments.length));
    PrintStream err = new PausingStream(arguments[0]);
    System.exit(Main.execute(command.toArray(String[]::new), System.out, err));
  }

  /** Standard error, whose writer waits after the line with the text. */
  private static final class PausingStream extends PrintStream {
    private final String text;

    PausingStream(String text) {
      super(System.err, true, StandardCharsets.UTF_8);
      this.text = text;
    }

    @Override
    public void println(String line) {
      super.println(line);
      if (line.contains(text)) {
        Eventually.await("the cancellation", PausingStream::cancelled);
      }
    }

    /** Returns whether the hook of Ctrl-C has cancelled the work and waits for its end. */
    private static boolean cancelled() {
      return Thread.getAllStackTraces().keySet().stream()
          .anyMatch(
              thread ->
                  thread.getName().equals("radiosity-cancel")
                      && thread.getState() == Thread.State.TIMED_WAITING);
    }
  }
}
