package org.selectiverenderer.polygon;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.x3d.read.ParsedNode;

/** A texture of a shape, with the pictures that it may show; compared by identity. */
final class TextureUse {
  private final ParsedNode texture;
  private final FilePolygonMeasurement file;
  private final Map<List<String>, Optional<TexturePicture>> pictures = new HashMap<>();

  TextureUse(ParsedNode texture, FilePolygonMeasurement file) {
    this.texture = texture;
    this.file = file;
  }

  ParsedNode texture() {
    return texture;
  }

  /** Returns the picture for some urls. */
  Optional<TexturePicture> picture(List<String> urls) {
    return pictures.computeIfAbsent(urls, wanted -> file.picture(texture, wanted));
  }
}
