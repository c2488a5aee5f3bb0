package org.selectiverenderer.polygon;

import java.util.List;
import org.selectiverenderer.schema.FieldQuality;
import org.selectiverenderer.schema.SwitchSchemas;
import org.selectiverenderer.x3d.read.ParsedNode;

/**
 * A texture whose picture is a quality of an object.
 *
 * @param texture the ImageTexture, whose urls the levels are
 */
record CountedTexture(ParsedNode texture, FieldQuality quality) implements ChoiceKey {
  SwitchSchemas schemas() {
    return quality.schemas();
  }

  /** Returns the level that the file shows; -1 for none. */
  int atStart() {
    List<String> written = List.of(texture.strings("url"));
    for (int level = 0; level < quality.levels().size(); level++) {
      if (quality.levels().get(level).values().equals(written)) {
        return level;
      }
    }
    return -1;
  }

  /** Returns the urls of a level; those of the file for -1. */
  List<String> urls(int level) {
    return level < 0 ? List.of(texture.strings("url")) : quality.levels().get(level).values();
  }
}
