package org.selectiverenderer.browser.sai;

import java.util.concurrent.locks.LockSupport;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.loading.SceneLoader;
import org.selectiverenderer.browser.scene.SafeListenerInvoker;
import org.web3d.x3d.sai.ExternalBrowser;
import org.web3d.x3d.sai.X3DComponent;

/**
 * The browser component that {@code BrowserFactory} returns: without a window, its world stepped 60
 * times a second by a thread of its own, {@code x3d-browser}, until {@link #shutdown()}. {@link
 * #getImplementation()} is the {@link World}, for a renderer to draw.
 */
final class EmbeddedComponent implements X3DComponent {
  private static final long FRAME_NANOS = 1_000_000_000L / 60;

  private final World world;
  private final SceneLoader loader;
  private final EmbeddedBrowser browser;
  private final Thread thread;
  private volatile boolean open = true;

  EmbeddedComponent(World world, SceneLoader loader, EmbeddedBrowser browser) {
    this.world = world;
    this.loader = loader;
    this.browser = browser;
    thread = new Thread(this::run, "x3d-browser");
    thread.setDaemon(true);
    thread.start();
  }

  private void run() {
    long start = System.nanoTime();
    for (long frame = 0; open; frame++) {
      double now = (System.nanoTime() - start) * 1e-9;
      SafeListenerInvoker.call(
          world.problems(),
          SourceLocation.of(world.scene().url()),
          "a frame",
          () -> world.step(now, (viewer, time, dt) -> {}));
      LockSupport.parkNanos(start + (frame + 1) * FRAME_NANOS - System.nanoTime());
    }
  }

  @Override
  public ExternalBrowser getBrowser() {
    return browser;
  }

  @Override
  public Object getImplementation() {
    return world;
  }

  @Override
  public void shutdown() {
    open = false;
    LockSupport.unpark(thread);
    if (Thread.currentThread() != thread) {
      try {
        thread.join();
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      }
    }
    browser.dispose();
    loader.close();
  }
}
