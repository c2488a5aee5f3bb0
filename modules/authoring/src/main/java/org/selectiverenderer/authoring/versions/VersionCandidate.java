package org.selectiverenderer.authoring.versions;

import java.util.Optional;

/**
 * An object of a scene that versions may be made of.
 *
 * @param start offset of its element in the text that was searched
 * @param type the name of its element: {@code Transform}
 * @param def its DEF name; empty for an object without one
 * @param name its DEF name, else a free one by what the object looks like in the file
 * @param polygons the number of its polygons
 * @param remark why it is not proposed; {@link Remark#NONE} for an object that is
 * @param obstacle why versions of it are impossible, as a sentence; empty if they are not
 */
public record VersionCandidate(
    int start,
    String type,
    Optional<String> def,
    String name,
    int polygons,
    Remark remark,
    String obstacle) {

  /** Why an object is not proposed. */
  public enum Remark {
    /** The object is proposed. */
    NONE,
    /** It has so few polygons that versions save nothing. */
    FEW,
    /** It is flat and spans much of the scene: a wall, a floor or a ceiling. */
    FLAT,
    /** It surrounds the scene, as a sky dome does or the shell of a room. */
    AROUND,
    /** It draws a node that others draw too (USE); versions of it would be a copy. */
    SHARED,
    /** It has versions. */
    VERSIONS,
    /** Versions are impossible, as {@link VersionCandidate#obstacle} says. */
    IMPOSSIBLE
  }

  /** Returns whether the object is one of those to make versions of, unless the author says no. */
  public boolean proposed() {
    return remark == Remark.NONE;
  }

  /**
   * Returns whether the object is proposed where the author says what few polygons are.
   *
   * @param fewest the fewest polygons of an object that is worth versions
   */
  public boolean proposed(int fewest) {
    return (remark == Remark.NONE || remark == Remark.FEW) && polygons >= fewest;
  }

  /** Returns whether versions can be made. */
  public boolean possible() {
    return remark != Remark.IMPOSSIBLE;
  }

  /** Returns the object with another name; one with a DEF name keeps it. */
  public VersionCandidate named(String other) {
    return def.isPresent()
        ? this
        : new VersionCandidate(start, type, def, other, polygons, remark, obstacle);
  }
}
