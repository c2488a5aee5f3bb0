package org.selectiverenderer.cli;

import java.io.OutputStream;
import java.io.PrintStream;
import java.util.Arrays;
import org.selectiverenderer.cli.base.ProgramVersion;
import org.selectiverenderer.cli.output.Console;

/**
 * Keeps what libraries print on standard error, JOGL's handled exceptions for instance, from users'
 * terminals. The program's own messages go through the {@link Console}.
 */
final class LibraryNoise {
  private LibraryNoise() {}

  /**
   * Silences {@code System.err} unless the user asked for details, and makes one line of what ends
   * a thread.
   *
   * @param err where the program's own messages go
   */
  static void silence(String[] args, PrintStream err) {
    if (Arrays.asList(args).contains("--debug") || RootCommand.debugByEnvironment()) {
      return;
    }
    System.setErr(new PrintStream(OutputStream.nullOutputStream()));
    Thread.setDefaultUncaughtExceptionHandler(
        (thread, failure) ->
            err.println(
                ProgramVersion.PROGRAM
                    + ": internal error in thread "
                    + thread.getName()
                    + ", please report it: "
                    + failure));
  }
}
