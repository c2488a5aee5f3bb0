package org.selectiverenderer.study.design;

import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;

/** The columns that every table of trials has, beside those of factors, stimuli and questions. */
public final class TrialColumns {
  /** The columns before those of factors and stimuli. */
  public static final List<String> FIRST =
      List.of("participant", "session", "group", "block", "trial", "round");

  /** The columns after those of factors and stimuli. */
  public static final List<String> RESULT = List.of("response", "ms", "correct");

  /** Names that analyses give to what they compute from these columns. */
  private static final List<String> COMPUTED = List.of("dprime", "threshold");

  private TrialColumns() {}

  /** Returns whether neither a factor nor a column of stimuli can have a name, in any case. */
  public static boolean reserved(String name) {
    return Stream.of(FIRST, RESULT, COMPUTED)
        .flatMap(List::stream)
        .anyMatch(name.strip().toLowerCase(Locale.ROOT)::equals);
  }
}
