package org.selectiverenderer.radiosity.trace;

import java.util.ArrayList;
import java.util.List;

/**
 * The versions of all objects. One version of each object, the reference, stands for the object in
 * the light of other bodies; every other version is lit as if it replaced the reference.
 */
public final class ObjectVersionIndex {
  /** The version number of bodies without versions. */
  public static final int FIXED = 0;

  private final List<Integer> objects = new ArrayList<>(List.of(0));
  private final List<Boolean> references = new ArrayList<>(List.of(true));

  /**
   * Adds a version.
   *
   * @param object the object's number, above 0, which its versions share
   * @return the number of the version
   */
  public int add(int object, boolean reference) {
    objects.add(object);
    references.add(reference);
    return objects.size() - 1;
  }

  public int count() {
    return objects.size();
  }

  /** Returns the object of a version; 0 for {@link #FIXED}. */
  public int object(int version) {
    return objects.get(version);
  }

  public boolean isReference(int version) {
    return references.get(version);
  }
}
