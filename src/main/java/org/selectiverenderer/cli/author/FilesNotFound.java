package org.selectiverenderer.cli.author;

import java.nio.file.Path;
import java.util.List;
import org.selectiverenderer.base.decimal.Counted;
import org.selectiverenderer.base.files.FileTransaction;
import org.selectiverenderer.cli.output.Console;

/** Tells of the files that a scene names and does not find from another folder. */
final class FilesNotFound {
  private FilesNotFound() {}

  /**
   * @param left the files, as {@link org.selectiverenderer.document.file.LeftBehind} finds them
   * @param output the scene in the other folder; what is no file, such as a pipe, has none
   */
  static void tell(List<String> left, Path output, Console console) {
    if (!left.isEmpty() && !FileTransaction.sink(output)) {
      console.message(
          "%s: %s that the scene names (%s%s) will not be found from here; write it into the folder of the scene, or copy them too"
              .formatted(
                  output,
                  Counted.of(left.size(), "file"),
                  left.get(0),
                  left.size() == 1 ? "" : " and others"));
    }
  }
}
