package org.selectiverenderer.study.definition;

import java.util.List;

/**
 * How a study uses the Lab Streaming Layer.
 *
 * @param lsl whether sessions send poses, gaze and events as streams
 * @param record predicates of the streams of other programs that sessions record, such as {@code
 *     type='EEG'}
 */
public record LslSettings(boolean lsl, List<String> record) {
  /** A study without streams. */
  public static final LslSettings NONE = new LslSettings(false, List.of());

  public LslSettings {
    record = List.copyOf(record);
  }

  /** Returns these settings with sending switched on. */
  public LslSettings sending() {
    return new LslSettings(true, record);
  }

  /** Returns whether the library is needed. */
  public boolean wanted() {
    return lsl || !record.isEmpty();
  }
}
