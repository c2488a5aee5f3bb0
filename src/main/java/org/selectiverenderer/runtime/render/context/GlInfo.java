package org.selectiverenderer.runtime.render.context;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GLProfile;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Objects;

/** What draws: the strings of the current context. */
public record GlInfo(String vendor, String renderer, String version) {
  /** The list of libraries inside the program; {@code ThirdPartyTest} holds its versions. */
  private static final String LIBRARIES = "/META-INF/THIRD-PARTY.txt";

  public static GlInfo of(GL gl) {
    return new GlInfo(
        string(gl, GL.GL_VENDOR), string(gl, GL.GL_RENDERER), string(gl, GL.GL_VERSION));
  }

  /** The version of JOGL, by which the program calls OpenGL; loads its native parts. */
  public static String binding() {
    JoglLibraries.use();
    GLProfile.initSingleton();
    return libraryVersion();
  }

  /** As the list has it: the manifest in which JOGL looks for its version is not in our jar. */
  static String libraryVersion() {
    try (InputStream in =
        Objects.requireNonNull(GlInfo.class.getResourceAsStream(LIBRARIES), LIBRARIES)) {
      return new String(in.readAllBytes(), StandardCharsets.UTF_8)
          .lines()
          .filter(line -> line.startsWith("org.jogamp.jogl:jogl-all "))
          .map(line -> line.split(" +")[1])
          .findFirst()
          .orElseThrow();
    } catch (IOException e) {
      throw new UncheckedIOException(LIBRARIES, e);
    }
  }

  /** Whether a processor draws, without a graphics card. */
  public boolean software() {
    return SoftwareRasterizers.named(renderer);
  }

  private static String string(GL gl, int name) {
    String value = gl.glGetString(name);
    return value == null ? "unknown" : value;
  }
}
