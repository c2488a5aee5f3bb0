package org.selectiverenderer.browser.loading;

import java.util.EnumMap;
import java.util.Map;
import org.selectiverenderer.browser.instance.Background;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.read.ParsedNode;

/**
 * Makes a texture node for each image that a Background names (X3D 4.0, 24.4.1), so that these
 * images are read, stored and replaced like those of shapes.
 */
final class BackgroundTextures {
  private BackgroundTextures() {}

  static boolean names(NodeType type) {
    return type.name().equals("Background");
  }

  /** Returns a texture for each side that has a url. */
  static Map<Background.Side, ParsedNode> of(ParsedNode background, NodeCatalogue catalogue) {
    Map<Background.Side, ParsedNode> pictures = new EnumMap<>(Background.Side.class);
    NodeType type = catalogue.get("ImageTexture");
    for (Background.Side side : Background.Side.values()) {
      String[] url = background.strings(side.urlField());
      if (url.length > 0) {
        ParsedNode texture = new ParsedNode(type, null, background.location());
        texture.put(type.indexOf("url"), url);
        pictures.put(side, texture);
      }
    }
    return pictures;
  }
}
