package org.selectiverenderer.radiosity.trace;

import java.util.ArrayList;
import java.util.List;

/**
 * The versions of objects: of each object one is there for all others, the reference; every other
 * one is lit as if it stood in the reference's place.
 */
public final class Versions {
  /** What has no versions. */
  public static final int FIXED = 0;

  private final List<Integer> objects = new ArrayList<>(List.of(0));
  private final List<Boolean> references = new ArrayList<>(List.of(true));

  /**
   * Adds a version.
   *
   * @param object a number above 0 that its versions share
   * @return its number
   */
  public int add(int object, boolean reference) {
    objects.add(object);
    references.add(reference);
    return objects.size() - 1;
  }

  public int count() {
    return objects.size();
  }

  /** The object of a version; 0 for what has none. */
  public int object(int version) {
    return objects.get(version);
  }

  public boolean isReference(int version) {
    return references.get(version);
  }
}
