package org.selectiverenderer.base.platform;

import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** Builds the command line that starts this program again as a child process. */
public final class ChildProcessCommand {
  /**
   * The system property set by a desktop launcher, which is started with files as its only
   * arguments: the program's command to run on them. A child process is given its own command.
   */
  public static final String DESKTOP = "selective-renderer.desktop";

  /** JVM flags that two processes cannot share, such as a debugger's port. */
  private static final List<String> OWN =
      List.of(
          "-agentlib:jdwp",
          "-Xrunjdwp",
          "-javaagent",
          "-D" + DESKTOP + "=",
          ParentProcessWatcher.FLAG);

  /** The first version of Java that warns of native code unless it is allowed. */
  private static final int WARNS_OF_NATIVE_CODE = 24;

  private ChildProcessCommand() {}

  /**
   * Returns a command with the Java command, JVM flags and class path of this process.
   *
   * @param mainClass the main class of the program
   * @param flags further JVM flags
   * @param arguments the program's arguments
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

  /**
   * Returns a command for a small child that gives untrusted data to native code. It has the Java
   * command and class path of this process, but none of its JVM flags: the child ends with this
   * process, starts quickly, has a heap of 128 MiB, and leaves nothing behind when it crashes.
   * Unlike {@link #of} this need not load Java's management classes, which takes longer than the
   * start of such a child.
   *
   * @param mainClass the main class of the child
   * @param properties prefixes of the names of the system properties that it has from this process
   */
  public static List<String> contained(String mainClass, List<String> properties) {
    return contained(mainClass, 128, properties);
  }

  /**
   * Returns a command as {@link #contained(String, List)} does, for a child with another heap.
   *
   * @param mainClass the main class of the child
   * @param heap the most that its heap may take, in MiB
   * @param properties prefixes of the names of the system properties that it has from this process
   */
  public static List<String> contained(String mainClass, int heap, List<String> properties) {
    List<String> flags =
        new ArrayList<>(
            List.of(
                "-XX:+IgnoreUnrecognizedVMOptions",
                "-Xlog:disable",
                "-XX:+DisplayVMOutputToStderr",
                // A crash is one line of this program, and leaves no file behind.
                "-XX:+SuppressFatalErrorMessage",
                "-XX:-CreateCoredumpOnCrash",
                "-Xmx" + heap + "m",
                "-Xss4m",
                "-XX:TieredStopAtLevel=1",
                "-XX:+UseSerialGC",
                "-XX:-UsePerfData",
                ParentProcessWatcher.flag(),
                "-Djava.awt.headless=true",
                "-Djava.io.tmpdir=" + System.getProperty("java.io.tmpdir"),
                "-Duser.home=" + System.getProperty("user.home")));
    if (Runtime.version().feature() >= WARNS_OF_NATIVE_CODE) {
      flags.add("--enable-native-access=ALL-UNNAMED");
      flags.add("--sun-misc-unsafe-memory-access=allow");
    }
    System.getProperties().stringPropertyNames().stream()
        .filter(name -> properties.stream().anyMatch(name::startsWith))
        .forEach(name -> flags.add("-D" + name + "=" + System.getProperty(name)));
    return minimal(mainClass, flags);
  }

  /**
   * Returns a command with the Java command and class path of this process, and JVM flags of its
   * own.
   *
   * @param mainClass the main class of the child
   * @param flags its JVM flags
   */
  public static List<String> minimal(String mainClass, List<String> flags) {
    List<String> command = new ArrayList<>();
    command.add(java());
    command.addAll(flags);
    command.addAll(List.of("-cp", System.getProperty("java.class.path"), mainClass));
    return command;
  }

  /**
   * Returns those of a process's JVM flags that it may pass to a child. A launcher that makes the
   * JVM by JNI has functions among its flags, with names such as {@code exit}: these it cannot pass
   * on.
   */
  static List<String> shared(List<String> flags) {
    return flags.stream()
        .filter(flag -> flag.startsWith("-") && OWN.stream().noneMatch(flag::startsWith))
        .toList();
  }

  private static String java() {
    Path folder = Path.of(System.getProperty("java.home"), "bin");
    return java(folder, System.getProperty(DESKTOP) != null)
        .or(() -> ProcessHandle.current().info().command())
        .orElse("java");
  }

  /**
   * Returns the Java command in a folder. It is looked for there since in a jpackage bundle this
   * process runs the bundle's launcher.
   *
   * @param folder the folder of Java's commands
   * @param unseen whether the program runs without a terminal; Windows would open one for {@code
   *     java.exe}
   */
  static Optional<String> java(Path folder, boolean unseen) {
    return Stream.of(unseen ? "javaw.exe" : "java", "java", "java.exe")
        .map(folder::resolve)
        .filter(Files::isExecutable)
        .map(Path::toString)
        .findFirst();
  }
}
