package org.selectiverenderer.cli.author;

import java.nio.file.Path;
import java.util.List;
import org.selectiverenderer.cli.output.Console;

/** Tells of what could not be tidied up after files have been written. */
final class LeftFiles {
  private LeftFiles() {}

  /**
   * @param left what {@link org.selectiverenderer.base.files.FileTransaction#commit} says
   */
  static void tell(List<Path> left, Console console) {
    for (Path file : left) {
      console.message(file + ": the previous file could not be deleted; you can delete it");
    }
  }
}
