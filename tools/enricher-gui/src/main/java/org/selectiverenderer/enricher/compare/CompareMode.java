package org.selectiverenderer.enricher.compare;

/** How two pictures share the preview. */
public enum CompareMode {
  /** There is one. */
  OFF,
  /** One over the other, with a line between them that is dragged. */
  WIPE,
  /** One beside the other, each of half the width. */
  BESIDE;

  /** The mode after this one, round and round. */
  public CompareMode next() {
    return values()[(ordinal() + 1) % values().length];
  }

  /** The width of each picture in one of that width. */
  public int width(int whole) {
    return this == BESIDE ? whole / 2 : whole;
  }
}
