package org.selectiverenderer.enricher.compare;

/** How two pictures share the preview's component. */
public enum CompareMode {
  /** Only the picture of the preview is shown. */
  OFF,
  /** One picture over the other, divided by a line that can be dragged. */
  WIPE,
  /** One beside the other, each of half the width. */
  BESIDE;

  /** The next mode; after the last the first. */
  public CompareMode next() {
    return values()[(ordinal() + 1) % values().length];
  }

  /** The width of each picture in a component of a width. */
  public int width(int whole) {
    return this == BESIDE ? whole / 2 : whole;
  }
}
