package org.selectiverenderer.enricher.text;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.ResourceBundle;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;

/**
 * Finds the translation of an English sentence by the patterns of a bundle: the document's code
 * makes its sentences in English, and the bundle has these as patterns, with their translations.
 */
final class SentencePatterns {
  private static final Pattern ARGUMENT = Pattern.compile("\\{\\d\\}");

  /**
   * @param text the key of the sentence in the bundle
   * @param literal number of its characters outside of arguments
   */
  private record Known(String text, Pattern pattern, int literal) {}

  private final List<Known> known = new ArrayList<>();

  /** Reads the patterns of a bundle, the more specific ones first. */
  SentencePatterns(String bundle) {
    ResourceBundle english =
        ResourceBundle.getBundle(
            SentencePatterns.class.getPackageName() + "." + bundle,
            Locale.ROOT,
            ResourceBundle.Control.getNoFallbackControl(ResourceBundle.Control.FORMAT_PROPERTIES));
    for (String key : english.keySet()) {
      String sentence = english.getString(key).replace("''", "'"); // as a MessageFormat has it
      String literal = ARGUMENT.matcher(sentence).replaceAll("");
      String pattern = "\\Q" + ARGUMENT.matcher(sentence).replaceAll("\\\\E(.+)\\\\Q") + "\\E";
      known.add(new Known(bundle + "." + key, Pattern.compile(pattern), literal.length()));
    }
    known.sort(Comparator.comparingInt(Known::literal).reversed().thenComparing(Known::text));
  }

  /** Returns a sentence in the language of the window; empty if it matches no pattern. */
  Optional<String> shown(String sentence) {
    for (Known each : known) {
      Matcher fits = each.pattern().matcher(sentence);
      if (fits.matches()) {
        return Optional.of(
            Texts.of(
                each.text(),
                IntStream.rangeClosed(1, fits.groupCount()).mapToObj(fits::group).toArray()));
      }
    }
    return Optional.empty();
  }
}
