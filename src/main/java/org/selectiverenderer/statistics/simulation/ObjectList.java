package org.selectiverenderer.statistics.simulation;

import java.util.List;

/**
 * Objects of one type that participants are asked for in an area: those that were present, and as
 * many that were absent.
 *
 * @param present how many were there: the O of the thesis's Tables 6 to 11
 */
public record ObjectList(String area, String type, int present) {
  /** Those of the thesis's Tables 6 to 11; neutral where they are not told apart. */
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

  /** Questions asked: the list has an absent object for each that was present (Appendix D). */
  public int questions() {
    return 2 * present;
  }
}
