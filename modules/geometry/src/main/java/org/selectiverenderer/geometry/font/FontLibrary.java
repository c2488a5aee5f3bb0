package org.selectiverenderer.geometry.font;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;

/** Loads the bundled fonts on first use and caches them. Thread-safe. */
public final class FontLibrary {
  private final Map<String, FontFace> fonts = new ConcurrentHashMap<>();

  /** Returns the font of a family in a style. */
  public FontFace font(FontFamily family, FontStyle style) {
    return fonts.computeIfAbsent(family.resource(style), FontLibrary::read);
  }

  private static FontFace read(String resource) {
    try (InputStream in = FontLibrary.class.getResourceAsStream(resource)) {
      if (in == null) {
        throw new IllegalStateException("the program's font " + resource + " is missing");
      }
      return new FontFace(new TrueTypeFile(ByteBuffer.wrap(in.readAllBytes())));
    } catch (IOException e) {
      throw new UncheckedIOException("the program's font " + resource + " cannot be read", e);
    }
  }
}
