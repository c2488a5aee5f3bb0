package org.selectiverenderer.experiment.study;

import java.util.List;

/**
 * What a study does with the Lab Streaming Layer.
 *
 * @param lsl whether sessions send poses, gaze and events
 * @param record conditions on the streams of others that sessions record, such as {@code
 *     type='EEG'}
 */
public record StudyStreams(boolean lsl, List<String> record) {
  /** Of a study that says nothing of it. */
  public static final StudyStreams NONE = new StudyStreams(false, List.of());

  public StudyStreams {
    record = List.copyOf(record);
  }

  /** The same, sending as well. */
  public StudyStreams sending() {
    return new StudyStreams(true, record);
  }

  /** Whether the library is needed. */
  public boolean wanted() {
    return lsl || !record.isEmpty();
  }
}
