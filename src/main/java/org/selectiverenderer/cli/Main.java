package org.selectiverenderer.cli;

import java.io.BufferedOutputStream;
import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Locale;
import org.selectiverenderer.cli.bundle.DesktopLauncherAdapter;
import org.selectiverenderer.command.LibraryProperties;
import org.selectiverenderer.command.ProgramVersion;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.StandardOutputStream;
import org.selectiverenderer.render.context.GlPreloader;
import picocli.CommandLine.Help.Ansi;

/**
 * The entry point of the program: runs the command of its arguments and exits with the command's
 * status.
 */
public final class Main {
  private Main() {}

  /** Runs one command and ends the process, whatever windows or threads are left. */
  public static void main(String[] typed) {
    LibraryProperties.set();
    DesktopLauncherAdapter desktop = DesktopLauncherAdapter.ofProcess();
    String[] args = desktop.arguments(typed);
    // Messages and reports are parsed by other programs, so numbers do not depend on the
    // machine's locale.
    Locale.setDefault(Locale.Category.FORMAT, Locale.ROOT);
    boolean terminal = Console.terminal();
    // In the shell of Git for Windows picocli takes pipes for terminals.
    boolean colours =
        Ansi.AUTO.enabled() && (terminal || !TerminalEncoding.windows(System.getProperties()));
    // UTF-8 whatever the platform's charset, because other programs read the output.
    PrintStream out =
        new PrintStream(
            new BufferedOutputStream(
                new StandardOutputStream(
                    TerminalEncoding.of(
                        System.getProperties(),
                        "stdout",
                        terminal,
                        new FileOutputStream(FileDescriptor.out))),
                1 << 16),
            colours,
            StandardCharsets.UTF_8);
    PrintStream err =
        new PrintStream(
            desktop.messages(
                TerminalEncoding.of(
                    System.getProperties(),
                    "stderr",
                    terminal,
                    new FileOutputStream(FileDescriptor.err))),
            true,
            StandardCharsets.UTF_8);
    StandardErrorSilencer.silence(args, new Console(out, err, colours));
    GlPreloader start = GlPreloader.begin(CommandCatalogue.draws(args));
    int status = execute(args, new Console(out, err, colours));
    start.await();
    desktop.tell(status);
    System.exit(status);
  }

  /** Runs one command within this process, as tests do, and returns its exit status. */
  public static int execute(String[] args, PrintStream out, PrintStream err) {
    return execute(args, new Console(out, err, false));
  }

  private static int execute(String[] args, Console console) {
    return new CommandRunner(console).run(args, CommandCatalogue.commands(console, args)).code();
  }

  /**
   * Suppresses the output of libraries on standard error, for instance JOGL's handled exceptions.
   * The program's own messages go through the {@link Console}.
   */
  private static final class StandardErrorSilencer {
    private StandardErrorSilencer() {}

    /**
     * Silences {@code System.err} unless the user asked for {@code --debug}, who gets it by the
     * console, and reports an uncaught exception of a thread in one line.
     *
     * @param console receives the program's own messages
     */
    static void silence(String[] args, Console console) {
      if (Arrays.asList(args).contains("--debug") || RootCommand.debugByEnvironment()) {
        System.setErr(console.err());
        return;
      }
      System.setErr(new PrintStream(OutputStream.nullOutputStream()));
      Thread.setDefaultUncaughtExceptionHandler(
          (thread, failure) ->
              console.message(
                  ProgramVersion.PROGRAM
                      + ": internal error in thread "
                      + thread.getName()
                      + ", please report it: "
                      + failure));
    }
  }
}
