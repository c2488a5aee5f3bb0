package org.selectiverenderer.experiment.study;

import org.selectiverenderer.base.json.JsonMembers;
import org.selectiverenderer.base.json.JsonValue;

/** Reads the key {@code streams} of a study. */
final class StudyStreamsReader {
  private StudyStreamsReader() {}

  static StudyStreams read(JsonMembers study) {
    return study
        .object("streams", "the streams", StudyStreamsReader::streams)
        .orElse(StudyStreams.NONE);
  }

  private static StudyStreams streams(JsonMembers keys) {
    for (JsonValue condition : keys.list("record", false)) {
      if (condition.text().isPresent() && condition.text().get().isBlank()) {
        keys.fault(condition, "a condition such as \"type='EEG'\" is needed, not an empty text");
      }
    }
    return new StudyStreams(keys.truth("lsl", false), keys.texts("record"));
  }
}
