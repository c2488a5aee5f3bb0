package org.selectiverenderer.experiment.questionnaire;

/**
 * Something to choose.
 *
 * @param value as tables have it; letters, digits, {@code . _ + -}
 * @param label what the participant reads on it
 * @param note what it means, where the label is a number; else empty
 * @param keys characters that choose it on a keyboard, in any case; may be none
 */
public record Option(String value, String label, String note, String keys) {
  /** An option whose label says all, chosen by a key. */
  public static Option of(String value, String label, String keys) {
    return new Option(value, label, "", keys);
  }
}
