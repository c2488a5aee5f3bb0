package org.selectiverenderer.base.machine;

import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** The command line that starts the program a second time, as this process was started. */
public final class ProgramCommand {
  /** Set by the launchers that jpackage makes: a bundle has its own Java, but no command for it. */
  private static final String BUNDLE = "jpackage.app-path";

  private ProgramCommand() {}

  /**
   * The same Java, flags and class path; in a bundle, its launcher.
   *
   * @param mainClass of the program
   * @param flags further flags for Java; a bundle's launcher takes none
   * @param arguments of the program
   */
  public static List<String> of(String mainClass, List<String> flags, List<String> arguments) {
    List<String> command = new ArrayList<>();
    Optional<String> bundle = Optional.ofNullable(System.getProperty(BUNDLE));
    if (bundle.isPresent()) {
      command.add(bundle.get());
    } else {
      command.add(ProcessHandle.current().info().command().orElse("java"));
      command.addAll(ManagementFactory.getRuntimeMXBean().getInputArguments());
      command.addAll(flags);
      command.addAll(List.of("-cp", System.getProperty("java.class.path"), mainClass));
    }
    command.addAll(arguments);
    return command;
  }
}
