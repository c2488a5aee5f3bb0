package org.selectiverenderer.statistics.script;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.Objects;
import org.selectiverenderer.statistics.detection.DetectionScorer;
import org.selectiverenderer.statistics.detection.ExtremeRateCorrection;
import org.selectiverenderer.statistics.detection.LowConfidencePolicy;

/** Generates R scripts that read a table in their own folder and repeat the analyses. */
public final class RScriptGenerator {
  /** The default file name of the script. */
  public static final String NAME = "analysis.R";

  private static final String TEMPLATE = "analysis.R";

  private RScriptGenerator() {}

  /**
   * Returns a script that analyses answers, scored as {@code experiment analyse} does by default.
   *
   * @param responsesFile name of a table with the columns {@code participant,condition,area,object,
   *     consistency,present,response,confidence}, separated by commas, in the script's folder
   */
  public static String analysis(String responsesFile) {
    return analysis(responsesFile, DetectionScorer.DEFAULT);
  }

  /** Returns a script with other choices of scoring. */
  public static String analysis(String responsesFile, DetectionScorer scoring) {
    return template(TEMPLATE)
        .replace("@RESPONSES@", quoted(responsesFile))
        .replace("@CORRECTION@", quoted(correction(scoring.correction())))
        .replace(
            "@GUESSES@",
            quoted(scoring.guessing() == LowConfidencePolicy.DISCARD ? "discard" : "no"));
  }

  /** Returns the name on the command line. */
  private static String correction(ExtremeRateCorrection correction) {
    return switch (correction) {
      case LOG_LINEAR -> "loglinear";
      case HALF_TRIAL -> "half";
      case NONE -> "none";
    };
  }

  /**
   * Returns an R string literal with escapes. Characters that R's strings cannot have, which are
   * NUL and halves of pairs, become the replacement character.
   */
  static String quoted(String text) {
    StringBuilder out = new StringBuilder("\"");
    text.codePoints()
        .forEach(
            c -> {
              if (c == '"' || c == '\\') {
                out.append('\\').appendCodePoint(c);
              } else if (c == 0 || c >= Character.MIN_SURROGATE && c <= Character.MAX_SURROGATE) {
                out.append("\\U{fffd}");
              } else if (c < ' ' || c > '~' || c == '@') {
                // The sign marks the places of the template.
                out.append(String.format(Locale.ROOT, "\\U{%x}", c));
              } else {
                out.appendCodePoint(c);
              }
            });
    return out.append('"').toString();
  }

  static String template(String name) {
    try (InputStream file =
        Objects.requireNonNull(RScriptGenerator.class.getResourceAsStream(name), name)) {
      return new String(file.readAllBytes(), StandardCharsets.UTF_8).replace("\r\n", "\n");
    } catch (IOException e) {
      throw new UncheckedIOException(e); // cannot happen: the template is in the program's own jar
    }
  }
}
