package org.selectiverenderer.render.context;

import com.jogamp.opengl.GLProfile;
import java.util.Optional;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

/**
 * Initialises OpenGL on a thread of its own, {@code gl-start}, in parallel to the loading of the
 * scene: loading and querying the driver takes longer than reading a small scene.
 */
public final class GlPreloader {
  private static final long LONGEST_S = 3;

  private final Optional<FutureTask<Boolean>> task;

  private GlPreloader(Optional<FutureTask<Boolean>> task) {
    this.task = task;
  }

  /**
   * Starts the initialisation; without a display it does nothing.
   *
   * @param wanted whether the program will draw anything
   */
  public static GlPreloader begin(boolean wanted) {
    if (!wanted) {
      return new GlPreloader(Optional.empty());
    }
    FutureTask<Boolean> task = new FutureTask<>(GlPreloader::start);
    Thread thread = new Thread(task, "gl-start");
    thread.setDaemon(true);
    thread.start();
    return new GlPreloader(Optional.of(task));
  }

  private static boolean start() {
    if (GlAvailability.checkNow().isPresent()) {
      return false; // JOGL would not look for a display again.
    }
    JoglNativeLibraries.use();
    return GLProfile.isAvailable(GLProfile.GL3);
  }

  /**
   * Waits until the initialisation has ended, because a process that exits earlier would unload the
   * driver during it. Waits for some seconds only, because an X server may accept a connection and
   * never answer.
   */
  public void await() {
    try {
      if (task.isPresent()) {
        task.get().get(LONGEST_S, TimeUnit.SECONDS);
      }
    } catch (TimeoutException e) {
      // The code that wanted to draw has reported that no X server answers.
    } catch (ExecutionException e) {
      // The code that opened a context met the same failure and has reported it.
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
