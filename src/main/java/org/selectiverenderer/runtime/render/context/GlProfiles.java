package org.selectiverenderer.runtime.render.context;

import com.jogamp.opengl.GLException;
import com.jogamp.opengl.GLProfile;
import java.util.Arrays;
import java.util.Optional;
import java.util.function.Supplier;

/** Finds out whether the driver has the OpenGL that is needed. */
public final class GlProfiles {
  private static final int TRIES = 6;
  private static final long PAUSE_MS = 500;

  private GlProfiles() {}

  /**
   * OpenGL 3.3 or newer, core profile. JOGL asks the display once; on a busy machine it may find
   * that no device can be opened. Then it is made to ask again, for some seconds.
   *
   * @throws GlUnavailableException which says whether it is the display or its driver
   */
  public static GLProfile core() {
    JoglLibraries.use();
    for (int tries = 1; ; tries++) {
      try {
        return begun(() -> GLProfile.get(GLProfile.GL3));
      } catch (GLException e) {
        Optional<String> best = best();
        if (best.isPresent()) {
          throw new GlUnavailableException(
              ("the display's driver has no OpenGL 3.3, but %s: install a newer driver, or let Mesa "
                      + "draw by the processor with LIBGL_ALWAYS_SOFTWARE=1")
                  .formatted(best.get()),
              e);
        }
        if (tries == TRIES) {
          throw new GlUnavailableException(
              "the display gives no OpenGL at all: its X server has gone, takes no more connections, or "
                  + "lacks the extension GLX; start another one, or try again",
              e);
        }
      }
      askAgain();
    }
  }

  /**
   * What JOGL answers. Its first answer takes as long as the driver takes to begin, perhaps on
   * another thread; JOGL's own limit to that is a system property.
   *
   * @throws GlUnavailableException when JOGL has waited as long as it may
   */
  static GLProfile begun(Supplier<GLProfile> answer) {
    try {
      return answer.get();
    } catch (RuntimeException e) {
      String message = String.valueOf(e.getMessage());
      if (e.getClass() == RuntimeException.class && message.startsWith("Waited ")) {
        throw new GlUnavailableException(
            "OpenGL has not begun in time, as the machine is very busy or its driver hangs: try again "
                + "when less runs, or with LIBGL_ALWAYS_SOFTWARE=1",
            e);
      }
      throw e;
    }
  }

  private static void askAgain() {
    try {
      Thread.sleep(PAUSE_MS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    GLProfile.shutdown();
    GLProfile.initSingleton();
  }

  /** The first of the profiles, best first, that there is. */
  private static Optional<String> best() {
    return Arrays.stream(GLProfile.GL_PROFILE_LIST_ALL).filter(GLProfile::isAvailable).findFirst();
  }
}
