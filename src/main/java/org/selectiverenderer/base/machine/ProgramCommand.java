package org.selectiverenderer.base.machine;

import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** The command line that starts the program a second time, as this process was started. */
public final class ProgramCommand {
  /**
   * Set by launchers that a desktop starts with files and nothing else: the program's command for
   * them. What is started here names its own.
   */
  public static final String DESKTOP = "selective-renderer.desktop";

  /** Flags that two processes cannot share, such as a debugger's port. */
  private static final List<String> OWN =
      List.of(
          "-agentlib:jdwp", "-Xrunjdwp", "-javaagent", "-D" + DESKTOP + "=", ParentProcess.FLAG);

  private ProgramCommand() {}

  /**
   * The same Java, flags and class path.
   *
   * @param mainClass of the program
   * @param flags further flags for Java
   * @param arguments of the program
   */
  public static List<String> of(String mainClass, List<String> flags, List<String> arguments) {
    List<String> command = new ArrayList<>();
    command.add(java());
    command.addAll(shared(ManagementFactory.getRuntimeMXBean().getInputArguments()));
    command.addAll(flags);
    command.addAll(List.of("-cp", System.getProperty("java.class.path"), mainClass));
    command.addAll(arguments);
    return command;
  }

  /** Those of a process's flags that one which it starts may have too. */
  static List<String> shared(List<String> flags) {
    return flags.stream().filter(flag -> OWN.stream().noneMatch(flag::startsWith)).toList();
  }

  private static String java() {
    Path folder = Path.of(System.getProperty("java.home"), "bin");
    return java(folder, System.getProperty(DESKTOP) != null)
        .or(() -> ProcessHandle.current().info().command())
        .orElse("java");
  }

  /**
   * In a bundle of jpackage this process is its launcher, and Java's own command lies inside.
   *
   * @param folder of Java's commands
   * @param unseen whether nobody sees a terminal: then Windows must not open one, as it does for
   *     {@code java.exe}
   */
  static Optional<String> java(Path folder, boolean unseen) {
    return Stream.of(unseen ? "javaw.exe" : "java", "java", "java.exe")
        .map(folder::resolve)
        .filter(Files::isExecutable)
        .map(Path::toString)
        .findFirst();
  }
}
