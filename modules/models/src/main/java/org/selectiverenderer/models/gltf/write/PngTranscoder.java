package org.selectiverenderer.models.gltf.write;

import java.io.IOException;
import org.selectiverenderer.x3d.url.UrlContent;

/**
 * Converts image files of other formats into PNG, which glTF can hold. This module decodes no
 * images; what uses it names a decoder.
 */
@FunctionalInterface
public interface PngTranscoder {
  /**
   * Returns the bytes of a PNG file of the same image.
   *
   * @throws IOException if the file cannot be converted, with a predicate that follows its name,
   *     such as "is a damaged image"
   */
  byte[] png(UrlContent file) throws IOException;
}
