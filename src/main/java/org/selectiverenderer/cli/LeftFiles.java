package org.selectiverenderer.cli;

import java.nio.file.Path;
import java.util.List;

/** Tells of what could not be tidied up after files have been written. */
final class LeftFiles {
  private LeftFiles() {}

  /**
   * @param left what {@link org.selectiverenderer.polygon.versions.FileTransaction#commit} says
   */
  static void tell(List<Path> left, Console console) {
    for (Path file : left) {
      console.message(file + ": the file as it was before could not be deleted; it may go");
    }
  }
}
