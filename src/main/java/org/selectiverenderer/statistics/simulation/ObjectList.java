package org.selectiverenderer.statistics.simulation;

import java.util.List;

/**
 * Objects of one type that participants are asked for in an area, every other one present.
 *
 * @param objects in all
 */
public record ObjectList(String area, String type, int objects) {
  /** Those of the thesis's Tables 6 to 11 (their O); neutral where they are not told apart. */
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
}
