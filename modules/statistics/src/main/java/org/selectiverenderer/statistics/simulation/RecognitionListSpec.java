package org.selectiverenderer.statistics.simulation;

import java.util.List;

/**
 * The part of a recognition list about one area and object type: the objects that were present, and
 * as many that were absent.
 *
 * @param present number of objects that were present: the O of the thesis's Tables 6 to 11
 */
public record RecognitionListSpec(String area, String type, int present) {
  /**
   * The lists of the thesis's Tables 6 to 11; the type is neutral where they do not distinguish
   * types.
   */
  public static final List<RecognitionListSpec> THESIS =
      List.of(
          new RecognitionListSpec("kitchen", "consistent", 12),
          new RecognitionListSpec("kitchen", "inconsistent", 6),
          new RecognitionListSpec("office", "neutral", 20),
          new RecognitionListSpec("desk", "consistent", 5),
          new RecognitionListSpec("desk", "inconsistent", 4),
          new RecognitionListSpec("bookcase", "neutral", 7),
          new RecognitionListSpec("lounge", "neutral", 17),
          new RecognitionListSpec("sofa", "consistent", 4),
          new RecognitionListSpec("sofa", "inconsistent", 4));

  /**
   * Returns the number of questions: the list has an absent object for each that was present
   * (Appendix D).
   */
  public int questions() {
    return 2 * present;
  }
}
