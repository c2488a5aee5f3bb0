package org.selectiverenderer.study.questionnaire;

import java.nio.file.Path;
import java.util.Optional;

/**
 * An option of a choice.
 *
 * @param value the value written to tables: letters, digits, {@code . _ + -}
 * @param label the text that the participant reads; of an option with a picture the text that is
 *     said instead
 * @param note the meaning of a number; else empty
 * @param keys characters that choose the option on a keyboard, in lower case; may be empty
 * @param picture the picture that is shown instead of the label
 */
public record ChoiceOption(
    String value, String label, String note, String keys, Optional<Path> picture) {
  /** An option without a picture. */
  public ChoiceOption(String value, String label, String note, String keys) {
    this(value, label, note, keys, Optional.empty());
  }

  /** Returns an option without a note. */
  public static ChoiceOption of(String value, String label, String keys) {
    return new ChoiceOption(value, label, "", keys);
  }
}
