package org.selectiverenderer.cli.author;

import java.nio.file.Path;
import java.util.List;
import org.selectiverenderer.cli.output.Console;

/** Warns about previous versions of files that could not be deleted after writing. */
final class UndeletedFilesWarning {
  private UndeletedFilesWarning() {}

  /**
   * @param left the result of {@link org.selectiverenderer.base.files.FileTransaction#commit}
   */
  static void tell(List<Path> left, Console console) {
    for (Path file : left) {
      console.message(file + ": the previous file could not be deleted; you can delete it");
    }
  }
}
