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
 * The names of steps in the language of the window. Those who edit the document know no window and
 * name steps in English; the bundle {@code steps} has these names, and what they are elsewhere. A
 * name that it has not is shown as it is.
 */
public final class StepNames {
  private static final Pattern ARGUMENT = Pattern.compile("\\{\\d\\}");

  /**
   * @param text the name in the bundle
   * @param literal how many of its letters are no arguments
   */
  private record Known(String text, Pattern pattern, int literal) {}

  private final List<Known> known = new ArrayList<>();

  /** Those of the bundle; where two fit a step, the one that says more of it comes first. */
  public StepNames() {
    ResourceBundle english =
        ResourceBundle.getBundle(
            StepNames.class.getPackageName() + ".steps",
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

  /** A step's name as the window shows it. */
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
