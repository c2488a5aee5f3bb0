package org.selectiverenderer.study.questionnaire;

/**
 * An option of a choice.
 *
 * @param value the value written to tables: letters, digits, {@code . _ + -}
 * @param label the text that the participant reads
 * @param note the meaning of a number; else empty
 * @param keys characters that choose the option on a keyboard, in lower case; may be empty
 */
public record ChoiceOption(String value, String label, String note, String keys) {
  /** Returns an option without a note. */
  public static ChoiceOption of(String value, String label, String keys) {
    return new ChoiceOption(value, label, "", keys);
  }
}
