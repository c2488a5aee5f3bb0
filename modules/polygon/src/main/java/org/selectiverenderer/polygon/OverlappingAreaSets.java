package org.selectiverenderer.polygon;

import java.util.ArrayList;
import java.util.List;

/** Enumerates the sets of areas that the viewer can be in at once, single areas included. */
final class OverlappingAreaSets {
  /** The largest number of sets per scope, since n areas in one place have 2^n sets. */
  static final int LIMIT = 500;

  private final List<Area> areas;
  private final List<List<Area>> sets = new ArrayList<>();
  private boolean complete = true;

  /**
   * @param areas the areas of one scope, in document order
   */
  OverlappingAreaSets(List<Area> areas) {
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

  /**
   * Returns the sets, smaller ones first; each set, and the sets of one size, are in document
   * order.
   */
  List<List<Area>> sets() {
    return List.copyOf(sets);
  }

  /** Returns whether these are all sets. */
  boolean complete() {
    return complete;
  }

  /**
   * Returns the sets with one more area, which follows the others in document order so that each
   * set is found once.
   */
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

  /** Returns whether the viewer can be in all areas of a set at once. */
  static boolean share(List<Area> set) {
    return share(set, 0, List.of());
  }

  /** Returns whether one box of each area can be chosen so that all these boxes overlap. */
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
