package org.selectiverenderer.study.questionnaire.read;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.study.questionnaire.Questionnaire;

/**
 * The standard questionnaires that come with the program, each in a file that cites its source.
 * Texts that do not exist in the study's language are in English.
 */
public final class StandardScales {
  /**
   * Names of the questionnaires: SUS presence (Slater, Usoh and Steed), igroup presence
   * questionnaire, and simulator sickness questionnaire (Kennedy and others).
   */
  public static final List<String> NAMES = List.of("sus", "ipq", "ssq");

  private StandardScales() {}

  /**
   * Returns one of the questionnaires.
   *
   * @param name one of {@link #NAMES}
   * @return empty if it has no texts in the language, which is then in {@code problems}
   * @throws IOException if the program's own files cannot be read
   */
  public static Optional<Questionnaire> of(String name, String language, ProblemCollector problems)
      throws IOException {
    return read(name + ".json", language, problems);
  }

  /** Returns the default form, consent and age, for a study without a form. */
  public static Optional<Questionnaire> form(String language, ProblemCollector problems)
      throws IOException {
    return read("form.json", language, problems);
  }

  private static Optional<Questionnaire> read(
      String file, String language, ProblemCollector problems) throws IOException {
    try (InputStream in =
        Objects.requireNonNull(StandardScales.class.getResourceAsStream(file), file)) {
      String text = new String(in.readAllBytes(), StandardCharsets.UTF_8);
      boolean known = text.contains("\"" + language + "\":");
      return QuestionnaireReader.parse(file, text, known ? language : "en", problems);
    }
  }
}
