package org.selectiverenderer.command.output;

import java.nio.file.Path;
import java.util.List;

/** Warns about previous versions of files that could not be deleted after writing. */
public final class UndeletedFilesWarning {
  private UndeletedFilesWarning() {}

  /**
   * @param left the result of {@link org.selectiverenderer.base.files.FileTransaction#commit}
   */
  public static void tell(List<Path> left, Console console) {
    for (Path file : left) {
      console.message(file + ": the previous file could not be deleted; you can delete it");
    }
  }
}
