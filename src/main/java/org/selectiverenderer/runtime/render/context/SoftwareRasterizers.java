package org.selectiverenderer.runtime.render.context;

import java.util.List;
import java.util.Locale;

/** The names of software renderers: drivers that draw on the processor. */
final class SoftwareRasterizers {
  /** Substrings of GL_RENDERER in lower case. */
  private static final List<String> NAMES =
      List.of(
          "llvmpipe", // Mesa
          "softpipe", // Mesa, slower
          "swrast", // Mesa, older
          "mesa x11", // Mesa without a driver
          "openswr", // Mesa, for many processors
          "lavapipe", // Mesa's Vulkan, by way of Zink
          "software rasterizer", // Mesa, older
          "swiftshader", // Google
          "microsoft basic render", // Windows: WARP
          "gdi generic", // Windows without a driver
          "apple software renderer");

  private SoftwareRasterizers() {}

  static boolean named(String renderer) {
    String name = renderer.toLowerCase(Locale.ROOT);
    return NAMES.stream().anyMatch(name::contains);
  }
}
