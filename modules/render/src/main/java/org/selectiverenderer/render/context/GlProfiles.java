package org.selectiverenderer.render.context;

import com.jogamp.opengl.GLException;
import com.jogamp.opengl.GLProfile;
import java.util.Arrays;
import java.util.Optional;
import java.util.function.Supplier;

/** Finds the OpenGL profile that the renderer needs. */
public final class GlProfiles {
  private static final int TRIES = 6;
  private static final long PAUSE_MS = 500;

  private GlProfiles() {}

  /**
   * Returns the core profile of OpenGL 3.3 or newer. JOGL asks the display only once, and on a busy
   * machine it may find that no device can be opened. Then it is restarted and asked again, for
   * some seconds.
   *
   * @throws GlUnavailableException if there is no such profile; the message tells whether the
   *     display or its driver is the reason
   */
  public static GLProfile core() {
    JoglNativeLibraries.use();
    for (int tries = 1; ; tries++) {
      try {
        return begun(() -> GLProfile.get(GLProfile.GL3));
      } catch (GLException e) {
        Optional<String> best = best();
        if (best.isPresent()) {
          throw new GlUnavailableException(
              tooOld(best.get(), System.getProperty("os.name", "")), e);
        }
        if (tries == TRIES) {
          throw new GlUnavailableException(
              "the display offers no OpenGL: its X server has ended, accepts no more connections, "
                  + "or lacks the GLX extension; start an X server with GLX, or try again",
              e);
        }
      }
      askAgain();
    }
  }

  /**
   * Returns JOGL's answer. The first one takes as long as the driver's start, perhaps on another
   * thread; JOGL limits that time by a system property.
   *
   * @throws GlUnavailableException if JOGL's time limit is exceeded
   */
  static GLProfile begun(Supplier<GLProfile> answer) {
    try {
      return answer.get();
    } catch (RuntimeException e) {
      String message = String.valueOf(e.getMessage());
      if (e.getClass() == RuntimeException.class && message.startsWith("Waited ")) {
        throw new GlUnavailableException(
            "OpenGL did not start in time: the machine is very busy or its driver hangs; try again "
                + "when fewer programs run"
                + (System.getProperty("os.name", "").equals("Linux")
                    ? ", or with LIBGL_ALWAYS_SOFTWARE=1"
                    : ", or update the driver"),
            e);
      }
      throw e;
    }
  }

  /**
   * Says what to do about an OpenGL that is too old.
   *
   * @param best the newest profile, as JOGL names it
   * @param system the name of the operating system, as in {@code os.name}
   */
  static String tooOld(String best, String system) {
    String advice;
    if (system.startsWith("Windows")) {
      advice =
          "install the driver of the graphics card's maker; Windows' own has none, and a remote"
              + " desktop may offer none";
    } else if (system.startsWith("Mac")) {
      advice = "use a newer version of macOS or a newer computer";
    } else {
      advice = "install a newer driver, or draw in software with LIBGL_ALWAYS_SOFTWARE=1";
    }
    return "the display's driver has no OpenGL 3.3, only " + best + ": " + advice;
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

  /** Returns the best profile that is available. */
  private static Optional<String> best() {
    return Arrays.stream(GLProfile.GL_PROFILE_LIST_ALL).filter(GLProfile::isAvailable).findFirst();
  }
}
