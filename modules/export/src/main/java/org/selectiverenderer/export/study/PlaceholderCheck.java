package org.selectiverenderer.export.study;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.selectiverenderer.base.files.InputFileReader;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.study.definition.Study;

/** Warns of texts in which the template's placeholder stands where the author's address should. */
final class PlaceholderCheck {
  /** The word as docs/examples/web has it; in other spellings it may be meant. */
  private static final Pattern PLACEHOLDER = Pattern.compile("\\bADDRESS\\b");

  private static final String COMMENT = "//";

  private PlaceholderCheck() {}

  /**
   * Warns of each line of the study file and its questionnaires.
   *
   * @throws IOException if a file cannot be read
   */
  static void warn(Study study, ProblemCollector problems) throws IOException {
    List<Path> files = new ArrayList<>(List.of(study.file()));
    files.addAll(study.questionnaires().files().values());
    for (Path file : files) {
      List<String> lines = InputFileReader.text(file).lines().toList();
      for (int i = 0; i < lines.size(); i++) {
        Matcher found = PLACEHOLDER.matcher(lines.get(i));
        if (!lines.get(i).strip().startsWith(COMMENT) && found.find()) {
          problems.warning(
              new SourceLocation(file.toString(), i + 1, found.start() + 1),
              "ADDRESS stands where who takes part looks for your address; write it, and export"
                  + " the study anew");
        }
      }
    }
  }
}
