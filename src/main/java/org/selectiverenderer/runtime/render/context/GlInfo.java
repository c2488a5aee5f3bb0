package org.selectiverenderer.runtime.render.context;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GLProfile;
import com.jogamp.opengl.JoglVersion;

/** What draws: the strings of the current context. */
public record GlInfo(String vendor, String renderer, String version) {
  public static GlInfo of(GL gl) {
    return new GlInfo(
        string(gl, GL.GL_VENDOR), string(gl, GL.GL_RENDERER), string(gl, GL.GL_VERSION));
  }

  /** The version of JOGL, by which the program calls OpenGL; loads its native parts. */
  public static String binding() {
    JoglLibraries.use();
    GLProfile.initSingleton();
    return JoglVersion.getInstance().getImplementationVersion();
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
