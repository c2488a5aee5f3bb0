package org.selectiverenderer.experiment.questionnaire.read;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.experiment.questionnaire.Questionnaire;

/**
 * The questionnaires that come with the program, each a file of its own that cites where its
 * questions are from. Texts that are not in the study's language are in English.
 */
public final class StandardScales {
  /**
   * Names: presence by Slater, Usoh and Steed, and by igroup; simulator sickness by Kennedy and
   * others.
   */
  public static final List<String> NAMES = List.of("sus", "ipq", "ssq");

  private StandardScales() {}

  /**
   * One of them.
   *
   * @param name one of {@link #NAMES}
   * @return empty when it has no texts in the language, which is then in {@code problems}
   * @throws IOException if the program's own files cannot be read
   */
  public static Optional<Questionnaire> of(String name, String language, Problems problems)
      throws IOException {
    return read(name + ".json", language, problems);
  }

  /** Consent and age of a study that has no form of its own. */
  public static Optional<Questionnaire> form(String language, Problems problems)
      throws IOException {
    return read("form.json", language, problems);
  }

  private static Optional<Questionnaire> read(String file, String language, Problems problems)
      throws IOException {
    try (InputStream in =
        Objects.requireNonNull(StandardScales.class.getResourceAsStream(file), file)) {
      String text = new String(in.readAllBytes(), StandardCharsets.UTF_8);
      boolean known = text.contains("\"" + language + "\":");
      return QuestionnaireReader.parse(file, text, known ? language : "en", problems);
    }
  }
}
