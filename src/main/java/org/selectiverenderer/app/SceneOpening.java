package org.selectiverenderer.app;

import java.io.IOException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;

/**
 * Loads a scene on a thread of its own, {@code scene-opener}, so that the caller can bring up its
 * display meanwhile.
 */
final class SceneOpening implements AutoCloseable {
  private final FutureTask<Walkthrough> task;
  private boolean taken;

  SceneOpening(RunSettings settings, RunListener listener) {
    task =
        new FutureTask<>(
            () ->
                Walkthrough.open(
                    settings.scene(),
                    settings.rendering(),
                    listener::problem,
                    listener::happened,
                    listener::printed));
    Thread thread = new Thread(task, "scene-opener");
    thread.setDaemon(true);
    thread.start();
  }

  /** Whether {@link #await()} returns at once. */
  boolean done() {
    return task.isDone();
  }

  /**
   * Waits for the scene and hands it over to the calling thread, which is to close it.
   *
   * @throws IOException when it cannot be read
   */
  Walkthrough await() throws IOException {
    taken = true;
    try {
      return task.get();
    } catch (ExecutionException e) {
      if (e.getCause() instanceof IOException failure) {
        throw failure;
      }
      if (e.getCause() instanceof RuntimeException failure) {
        throw failure;
      }
      if (e.getCause() instanceof Error failure) {
        throw failure;
      }
      throw new IllegalStateException(e.getCause());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IOException("interrupted while the scene was being read", e);
    }
  }

  /** Waits for a scene that nobody asked for, and closes it. */
  @Override
  public void close() throws IOException {
    if (!taken) {
      await().close();
    }
  }
}
