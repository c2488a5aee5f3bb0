package org.selectiverenderer.statistics.simulation;

import java.util.List;

/**
 * The part of a recognition list about one area and object type: the objects that were present, and
 * as many that were absent.
 *
 * @param present number of objects that were present: the O of the thesis's Tables 6 to 11
 */
public record ObjectList(String area, String type, int present) {
  /**
   * The lists of the thesis's Tables 6 to 11; the type is neutral where they do not distinguish
   * types.
   */
  public static final List<ObjectList> THESIS =
      List.of(
          new ObjectList("kitchen", "consistent", 12),
          new ObjectList("kitchen", "inconsistent", 6),
          new ObjectList("office", "neutral", 20),
          new ObjectList("desk", "consistent", 5),
          new ObjectList("desk", "inconsistent", 4),
          new ObjectList("bookcase", "neutral", 7),
          new ObjectList("lounge", "neutral", 17),
          new ObjectList("sofa", "consistent", 4),
          new ObjectList("sofa", "inconsistent", 4));

  /**
   * Returns the number of questions: the list has an absent object for each that was present
   * (Appendix D).
   */
  public int questions() {
    return 2 * present;
  }
}
