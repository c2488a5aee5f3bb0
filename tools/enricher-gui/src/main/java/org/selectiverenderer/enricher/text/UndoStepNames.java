package org.selectiverenderer.enricher.text;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.ResourceBundle;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;

/**
 * Translates the names of undo steps into the language of the window. The document's edits name
 * their steps in English; the bundle {@code steps} has these names as patterns, and their
 * translations. A name that matches none is shown as it is.
 */
public final class UndoStepNames {
  private static final Pattern ARGUMENT = Pattern.compile("\\{\\d\\}");

  /**
   * @param text the key of the name in the bundle
   * @param literal number of its characters outside of arguments
   */
  private record Known(String text, Pattern pattern, int literal) {}

  private final List<Known> known = new ArrayList<>();

  /** Reads the patterns of the bundle, the more specific ones first. */
  public UndoStepNames() {
    ResourceBundle english =
        ResourceBundle.getBundle(
            UndoStepNames.class.getPackageName() + ".steps",
            Locale.ROOT,
            ResourceBundle.Control.getNoFallbackControl(ResourceBundle.Control.FORMAT_PROPERTIES));
    for (String key : english.keySet()) {
      String name = english.getString(key);
      String literal = ARGUMENT.matcher(name).replaceAll("");
      String pattern = "\\Q" + ARGUMENT.matcher(name).replaceAll("\\\\E(.+)\\\\Q") + "\\E";
      known.add(new Known("steps." + key, Pattern.compile(pattern), literal.length()));
    }
    known.sort(Comparator.comparingInt(Known::literal).reversed().thenComparing(Known::text));
  }

  /** Returns a step's name in the language of the window. */
  public String shown(String name) {
    for (Known each : known) {
      Matcher fits = each.pattern().matcher(name);
      if (fits.matches()) {
        return Texts.of(
            each.text(),
            IntStream.rangeClosed(1, fits.groupCount()).mapToObj(fits::group).toArray());
      }
    }
    return name;
  }
}
