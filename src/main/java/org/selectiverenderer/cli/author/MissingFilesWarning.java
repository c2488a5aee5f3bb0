package org.selectiverenderer.cli.author;

import java.nio.file.Path;
import java.util.List;
import org.selectiverenderer.base.decimal.Pluralizer;
import org.selectiverenderer.base.files.FileTransaction;
import org.selectiverenderer.command.output.Console;

/**
 * Warns about the files that a scene refers to by relative URLs and cannot find from its output
 * folder.
 */
final class MissingFilesWarning {
  private MissingFilesWarning() {}

  /**
   * @param left the files, as {@link org.selectiverenderer.authoring.file.BrokenRelativeUrls} finds
   *     them
   * @param output the written scene; nothing is reported for a pipe or device
   */
  static void tell(List<String> left, Path output, Console console) {
    if (!left.isEmpty() && !FileTransaction.sink(output)) {
      console.message(
          ("%s: %s that the scene refers to (%s%s) cannot be found from this folder; write the"
                  + " output into the folder of the scene, or copy these files too")
              .formatted(
                  output,
                  Pluralizer.of(left.size(), "file"),
                  left.get(0),
                  left.size() == 1 ? "" : " and others"));
    }
  }
}
