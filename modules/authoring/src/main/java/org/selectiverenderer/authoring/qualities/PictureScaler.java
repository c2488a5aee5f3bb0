package org.selectiverenderer.authoring.qualities;

import java.io.IOException;
import java.nio.file.Path;

/** Makes smaller pictures. */
@FunctionalInterface
public interface PictureScaler {
  /**
   * Returns the file of a smaller picture: a JPEG of a JPEG, else a PNG.
   *
   * @param percent of each side, above 0 and below 100
   * @throws IOException if the picture cannot be read, with a one-line message that names it
   */
  byte[] scaled(Path picture, double percent) throws IOException;
}
