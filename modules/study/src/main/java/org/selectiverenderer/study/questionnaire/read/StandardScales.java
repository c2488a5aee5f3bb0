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

  /** Name of the default form, consent and age, for a study without a form. */
  public static final String FORM = "form";

  private StandardScales() {}

  /**
   * Returns one of the questionnaires.
   *
   * @param name one of {@link #NAMES}, or {@link #FORM}
   * @return empty if it has no texts in the language, which is then in {@code problems}
   * @throws IOException if the program's own files cannot be read
   */
  public static Optional<Questionnaire> of(String name, String language, ProblemCollector problems)
      throws IOException {
    return read(name + ".json", language, problems);
  }

  /**
   * Returns whether one of the questionnaires has texts in a language; without, it is English.
   *
   * @param name one of {@link #NAMES}, or {@link #FORM}
   * @throws IOException if the program's own files cannot be read
   */
  public static boolean has(String name, String language) throws IOException {
    return text(name + ".json").contains("\"" + language + "\":");
  }

  private static Optional<Questionnaire> read(
      String file, String language, ProblemCollector problems) throws IOException {
    String text = text(file);
    boolean known = text.contains("\"" + language + "\":");
    return QuestionnaireReader.parse(file, text, known ? language : "en", problems);
  }

  private static String text(String file) throws IOException {
    try (InputStream in =
        Objects.requireNonNull(StandardScales.class.getResourceAsStream(file), file)) {
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    }
  }
}
