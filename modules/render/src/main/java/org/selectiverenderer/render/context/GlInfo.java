package org.selectiverenderer.render.context;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GLProfile;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Properties;

/** The OpenGL driver: vendor, renderer and version strings of a context. */
public record GlInfo(String vendor, String renderer, String version) {
  /** Written by the build, from the POM. */
  private static final String VERSIONS = "libraries.properties";

  public static GlInfo of(GL gl) {
    return new GlInfo(
        string(gl, GL.GL_VENDOR), string(gl, GL.GL_RENDERER), string(gl, GL.GL_VERSION));
  }

  /** Returns the version of JOGL; loads its native libraries. */
  public static String binding() {
    JoglNativeLibraries.use();
    GLProfile.initSingleton();
    return libraryVersion();
  }

  /**
   * Returns the version that the build names, because our jar lacks the manifest in which JOGL
   * looks for its own.
   */
  static String libraryVersion() {
    try (InputStream in =
        Objects.requireNonNull(GlInfo.class.getResourceAsStream(VERSIONS), VERSIONS)) {
      Properties versions = new Properties();
      versions.load(in);
      return versions.getProperty("jogl.version");
    } catch (IOException e) {
      throw new UncheckedIOException(VERSIONS, e);
    }
  }

  /** Returns whether it is a software renderer, which draws without a graphics card. */
  public boolean software() {
    return SoftwareRasterizers.named(renderer);
  }

  private static String string(GL gl, int name) {
    String value = gl.glGetString(name);
    return value == null ? "unknown" : value;
  }

  /** The names of software renderers: drivers that draw on the processor. */
  private static final class SoftwareRasterizers {
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
}
