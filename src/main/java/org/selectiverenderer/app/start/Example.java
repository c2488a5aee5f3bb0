package org.selectiverenderer.app.start;

import java.util.Locale;

/** An example that the start window shows with a picture. */
public enum Example {
  TRASH_CAN("scenes/trashcan.x3d", true),
  APARTMENT("scenes/apartment.x3d", true),
  SCULPTURES("docs/examples/sculptures.x3dv", false);

  private final String scene;
  private final boolean enriched;

  Example(String scene, boolean enriched) {
    this.scene = scene;
    this.enriched = enriched;
  }

  /** Returns the name of its scene among the examples, with slashes. */
  public String scene() {
    return scene;
  }

  /** Returns whether the enricher edits the scene, which is so of XML alone. */
  public boolean enriched() {
    return enriched;
  }

  /** Returns its name in texts and of its picture. */
  public String key() {
    return name().toLowerCase(Locale.ROOT).replace('_', '-');
  }
}
