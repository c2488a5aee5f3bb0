package org.selectiverenderer.app.run;

import java.io.IOException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import org.selectiverenderer.app.settings.SceneSettings;
import org.selectiverenderer.walkthrough.Walkthrough;

/**
 * Loads a scene on a thread of its own, {@code scene-opener}, so that the caller can bring up its
 * display meanwhile.
 */
final class BackgroundSceneLoader implements AutoCloseable {
  private final FutureTask<Walkthrough> task;

  BackgroundSceneLoader(SceneSettings scene, RunListener listener) {
    task = new FutureTask<>(() -> open(scene, listener));
    Thread thread = new Thread(task, "scene-opener");
    thread.setDaemon(true);
    thread.start();
  }

  private static Walkthrough open(SceneSettings scene, RunListener listener) throws IOException {
    Walkthrough walk =
        Walkthrough.open(
            scene.file(),
            scene.rendering(),
            scene.access(),
            world -> world.instances().boxes().begin(),
            listener::problem,
            listener::happened,
            listener::printed);
    try {
      if (listener.observesSwitches()) {
        walk.observeSwitches();
      }
      walk.prepareFrames();
      listener.opened();
      return walk;
    } catch (IOException | RuntimeException | Error e) {
      walk.close();
      throw e;
    }
  }

  /** Returns whether {@link #await()} returns at once. */
  boolean done() {
    return task.isDone();
  }

  /**
   * Waits for the scene and hands it over to the calling thread.
   *
   * @throws IOException when it cannot be read
   */
  Walkthrough await() throws IOException {
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
      throw new IOException("interrupted while reading the scene", e);
    }
  }

  /** Waits for the scene and closes it, unless it could not be read. */
  @Override
  public void close() {
    try {
      task.get().close();
    } catch (ExecutionException e) {
      // The caller of await() got the exception; without one the run was given up before.
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
