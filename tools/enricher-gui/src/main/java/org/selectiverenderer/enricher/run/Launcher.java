package org.selectiverenderer.enricher.run;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** Starts commands of the program in processes of their own. */
public final class Launcher {
  /** By its name: the command line uses the enricher, not the other way round. */
  static final String MAIN = "org.selectiverenderer.cli.Main";

  /** Flags that two processes cannot share: a debugger's port. */
  private static final List<String> OWN = List.of("-agentlib:jdwp", "-Xrunjdwp", "-javaagent");

  private Launcher() {}

  /** The words of a command, with this process's Java, flags and class path. */
  static List<String> command(List<String> words) {
    List<String> command = new ArrayList<>();
    command.add(
        ProcessHandle.current()
            .info()
            .command()
            .orElse(Path.of(System.getProperty("java.home"), "bin", "java").toString()));
    ManagementFactory.getRuntimeMXBean().getInputArguments().stream()
        .filter(flag -> OWN.stream().noneMatch(flag::startsWith))
        .forEach(command::add);
    command.addAll(List.of("-cp", System.getProperty("java.class.path"), MAIN));
    command.addAll(words);
    return command;
  }

  /** Starts a command whose messages are to be read. */
  static Process start(List<String> words) throws IOException {
    return new ProcessBuilder(command(words)).redirectErrorStream(true).start();
  }

  /**
   * Opens a scene in an enricher of its own, which goes on when this one ends.
   *
   * @throws IOException if it cannot be started
   */
  public static void enrich(Path scene) throws IOException {
    new ProcessBuilder(command(List.of("enrich", scene.toString())))
        .redirectErrorStream(true)
        .redirectOutput(ProcessBuilder.Redirect.DISCARD)
        .start();
  }
}
