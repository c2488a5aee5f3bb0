package org.selectiverenderer.cli.bundle;

import java.util.stream.Stream;

/**
 * The command line of a start from a desktop, where files are all that is given: one that is opened
 * is shown, and without one the enricher opens.
 */
public final class DesktopStart {
  private DesktopStart() {}

  /**
   * @param files what the desktop gives
   * @param command {@code run} or {@code enrich}, what is done with a file
   * @return the arguments of the program
   */
  public static String[] arguments(String[] files, String command) {
    if (files.length == 0) {
      return new String[] {"enrich"};
    }
    return Stream.concat(Stream.of(command), Stream.of(files)).toArray(String[]::new);
  }
}
