package org.selectiverenderer.runtime.render.context;

import com.jogamp.opengl.GLProfile;
import java.util.Optional;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

/**
 * Begins OpenGL on a thread of its own, {@code gl-start}, while the program finds out what it is to
 * draw: to load the driver and to ask it what it can takes longer than to read a small scene.
 */
public final class GlStart {
  private static final long LONGEST_S = 3;

  private final Optional<FutureTask<Boolean>> task;

  private GlStart(Optional<FutureTask<Boolean>> task) {
    this.task = task;
  }

  /**
   * Begins it; where there is no display nothing comes of it.
   *
   * @param wanted whether anything will be drawn
   */
  public static GlStart begin(boolean wanted) {
    if (!wanted) {
      return new GlStart(Optional.empty());
    }
    FutureTask<Boolean> task = new FutureTask<>(GlStart::start);
    Thread thread = new Thread(task, "gl-start");
    thread.setDaemon(true);
    thread.start();
    return new GlStart(Optional.of(task));
  }

  private static boolean start() {
    if (GlAvailability.checkNow().isPresent()) {
      return false; // Without a server that answers JOGL would find none, once and for all.
    }
    JoglLibraries.use();
    return GLProfile.isAvailable(GLProfile.GL3);
  }

  /**
   * Waits until it has begun: a process that ends before would pull the driver from under it. Not
   * for long, as an X server may take a connection and never answer.
   */
  public void await() {
    try {
      if (task.isPresent()) {
        task.get().get(LONGEST_S, TimeUnit.SECONDS);
      }
    } catch (TimeoutException e) {
      // Whoever wanted to draw has heard that nobody answers.
    } catch (ExecutionException e) {
      // Whoever opened a context met the same failure and has told it.
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
