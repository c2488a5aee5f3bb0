package org.selectiverenderer.statistics.detection;

import java.util.List;
import org.selectiverenderer.base.problem.SourceLocation;

/**
 * A participant's answer to one object of the memory recognition questionnaire (thesis Fig 86).
 *
 * @param condition the participant's group
 * @param type the object's type: consistent, inconsistent or neutral
 * @param present whether the object was in the scene
 * @param yes whether the participant answered that it was
 * @param confidence 1 (none) to 5 (certain); 0 when it was not given
 * @param location location of the answer in its file
 */
public record Response(
    String participant,
    String condition,
    String area,
    String object,
    String type,
    boolean present,
    boolean yes,
    int confidence,
    SourceLocation location) {
  /** Types of objects, in the order of tables; one whose type changes with the area is neutral. */
  public static final List<String> TYPES = List.of("consistent", "inconsistent", "neutral");

  /** The smallest confidence of the questionnaire. */
  public static final int LEAST_CONFIDENCE = 1;

  /** The largest confidence of the questionnaire. */
  public static final int MOST_CONFIDENCE = 5;
}
