package org.selectiverenderer.polygon.count;

import java.util.ArrayList;
import java.util.List;

/** The sets of areas that the viewer can be in at once, single areas included. */
final class AreaSets {
  /** Sets of a scope beyond which no more are looked for; many areas in one place make 2^n. */
  static final int LIMIT = 500;

  private final List<Area> areas;
  private final List<List<Area>> sets = new ArrayList<>();
  private boolean complete = true;

  /**
   * @param areas of one scope, in document order
   */
  AreaSets(List<Area> areas) {
    this.areas = areas;
    List<List<Area>> size = new ArrayList<>();
    for (Area area : areas) {
      size.add(List.of(area));
    }
    while (!size.isEmpty()) {
      sets.addAll(size);
      size = larger(size);
    }
  }

  /** Small sets first, each set and the sets of one size in document order. */
  List<List<Area>> sets() {
    return List.copyOf(sets);
  }

  /** Whether there are no more. */
  boolean complete() {
    return complete;
  }

  /** The sets with one area more, of those that come later so that each set is found once. */
  private List<List<Area>> larger(List<List<Area>> size) {
    List<List<Area>> larger = new ArrayList<>();
    for (List<Area> set : size) {
      int last = areas.indexOf(set.get(set.size() - 1));
      for (Area next : areas.subList(last + 1, areas.size())) {
        if (sets.size() + larger.size() >= LIMIT) {
          complete = false;
          return larger;
        }
        List<Area> wider = new ArrayList<>(set);
        wider.add(next);
        if (share(wider)) {
          larger.add(wider);
        }
      }
    }
    return larger;
  }

  /** Whether the viewer can be in all of some areas at once. */
  static boolean share(List<Area> set) {
    return share(set, 0, List.of());
  }

  /** Whether one box of each area can be chosen so that these share a place. */
  private static boolean share(List<Area> set, int from, List<SensorBox> chosen) {
    if (from == set.size()) {
      return true;
    }
    for (SensorBox box : set.get(from).boxes) {
      List<SensorBox> more = new ArrayList<>(chosen);
      more.add(box);
      if (SensorBox.share(more) && share(set, from + 1, more)) {
        return true;
      }
    }
    return false;
  }
}
