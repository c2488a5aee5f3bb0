package org.selectiverenderer.cli;

import java.io.OutputStream;
import java.io.PrintStream;
import java.util.Arrays;
import org.selectiverenderer.cli.base.ProgramVersion;
import org.selectiverenderer.cli.output.Console;

/**
 * Suppresses the output of libraries on standard error, for instance JOGL's handled exceptions. The
 * program's own messages go through the {@link Console}.
 */
final class LibraryNoise {
  private LibraryNoise() {}

  /**
   * Silences {@code System.err} unless the user asked for {@code --debug}, and reports an uncaught
   * exception of a thread in one line.
   *
   * @param err stream of the program's own messages
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
