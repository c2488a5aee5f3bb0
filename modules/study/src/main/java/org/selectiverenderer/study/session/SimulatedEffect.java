package org.selectiverenderer.study.session;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.selectiverenderer.study.design.Trial;

/**
 * What simulated participants do otherwise in some trials.
 *
 * @param at the levels, or cells of the stimulus, that a trial must have, by factor or column
 * @param measure {@link #MILLISECONDS}, {@link #CORRECT}, or the id of a question
 * @param amount what is added: milliseconds, a share of correct responses, or steps of the scale
 */
public record SimulatedEffect(Map<String, String> at, String measure, double amount) {
  /** The response time. */
  public static final String MILLISECONDS = "ms";

  /** The probability of a correct response. */
  public static final String CORRECT = "correct";

  private static final Pattern TEXT =
      Pattern.compile("([^:]+):([^:]+?)([+-][0-9]{1,9}(?:\\.[0-9]{1,9})?)");

  /** Makes a defensive copy, so that the record is immutable. */
  public SimulatedEffect {
    at = Map.copyOf(at);
  }

  /**
   * Reads an effect such as {@code quality=reduced,light=off:ms+80}; empty if it has another form.
   */
  public static Optional<SimulatedEffect> of(String text) {
    Matcher parts = TEXT.matcher(text);
    if (!parts.matches()) {
      return Optional.empty();
    }
    Map<String, String> at = new LinkedHashMap<>();
    for (String pair : parts.group(1).split(",", -1)) {
      int sign = pair.indexOf('=');
      if (sign < 1 || at.put(pair.substring(0, sign), pair.substring(sign + 1)) != null) {
        return Optional.empty();
      }
    }
    return Optional.of(new SimulatedEffect(at, parts.group(2), Double.parseDouble(parts.group(3))));
  }

  boolean concerns(Trial trial) {
    return at.entrySet().stream()
        .allMatch(
            pair -> {
              String cell = trial.stimulus().getOrDefault(pair.getKey(), "");
              return trial.levels().getOrDefault(pair.getKey(), cell).equals(pair.getValue());
            });
  }
}
