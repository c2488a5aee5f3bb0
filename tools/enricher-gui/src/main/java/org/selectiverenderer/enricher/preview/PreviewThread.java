package org.selectiverenderer.enricher.preview;

import java.util.Optional;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.viewer.Pose;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.render.context.GlUnavailableException;
import org.selectiverenderer.render.preview.ScenePreviewRenderer;

/**
 * The thread {@code enricher-preview}: owns the GL context and the running scene, executes commands
 * in order, and draws when something has changed, or thirty times a second while the author walks.
 */
final class PreviewThread implements AutoCloseable, PreviewUpdater.Target {
  /** Receives frames and failures, on the preview's thread. */
  interface Listener {
    void drawn(PreviewFrame frame);

    /**
     * Something cannot be shown.
     *
     * @param sentence a sentence that says what and why
     */
    void failed(String sentence);
  }

  /** Nanoseconds without a command after which a smooth frame follows frames with few samples. */
  private static final long REST = TimeUnit.MILLISECONDS.toNanos(250);

  private static final long FRAME = TimeUnit.SECONDS.toNanos(1) / 30;

  private final LinkedBlockingQueue<Consumer<PreviewController>> told = new LinkedBlockingQueue<>();
  private final AtomicReference<@Nullable LoadedPreview> next = new AtomicReference<>();

  /** The scene that was handed over last; null where nothing can be shown. */
  private volatile @Nullable LoadedPreview last;

  private final Listener listener;
  private final Thread thread;
  private volatile boolean ended;
  private volatile Optional<Pose> pose = Optional.empty();
  private volatile Optional<AnimationPhase> animation = Optional.empty();

  PreviewThread(Listener listener) {
    this.listener = listener;
    thread = new Thread(this::run, "enricher-preview");
    thread.setDaemon(true);
    thread.start();
  }

  /** Queues a command for the stage, after which a frame is drawn. Thread-safe. */
  void tell(Consumer<PreviewController> what) {
    ask(
        stage -> {
          what.accept(stage);
          stage.changed();
        });
  }

  /** Queues a command for the stage, which decides itself whether to draw. Thread-safe. */
  void ask(Consumer<PreviewController> what) {
    told.add(what);
  }

  /**
   * Queues a patch of the scene that was handed over last. On the caller's thread its new nodes are
   * read, with the files that they name: the picture does not wait for them.
   *
   * @param refused runs on either thread if the patch does not apply and the scene must be loaded
   */
  @Override
  public void patch(ScenePatch patch, Runnable refused) {
    LoadedPreview of = last;
    if (of == null) {
      return; // There is no picture.
    }
    AddedNodes added;
    try {
      added = AddedNodes.of(patch, of);
    } catch (RuntimeException e) { // As when its loader has been closed meanwhile.
      refused.run();
      return;
    }
    ask(
        stage -> {
          if (!stage.patch(patch, added)) {
            refused.run();
          }
        });
  }

  /** Whether the thread runs: not where there is no OpenGL, nor after the end. Thread-safe. */
  boolean alive() {
    return thread.isAlive();
  }

  /** The viewer's pose in the last picture; empty before the first. Thread-safe. */
  Optional<Pose> pose() {
    return pose;
  }

  /** Where the animation stands in the last picture; empty for a scene without. Thread-safe. */
  Optional<AnimationPhase> animation() {
    return animation;
  }

  /** Hands over a loaded scene, which replaces one that has not been shown yet. Thread-safe. */
  @Override
  public void show(LoadedPreview loaded) {
    last = loaded;
    replaceNext(loaded);
    tell(
        stage -> {
          LoadedPreview newest = next.getAndSet(null);
          if (newest != null) {
            stage.show(newest);
          }
        });
    if (!thread.isAlive()) {
      last = null;
      replaceNext(null);
    }
  }

  private void replaceNext(@Nullable LoadedPreview loaded) {
    LoadedPreview overtaken = next.getAndSet(loaded);
    if (overtaken != null) {
      overtaken.close();
    }
  }

  private void run() {
    try (ScenePreviewRenderer view = ScenePreviewRenderer.open();
        PreviewController stage = new PreviewController(view)) {
      serve(stage);
    } catch (GlUnavailableException e) {
      listener.failed(Texts.of("preview.none", String.valueOf(e.getMessage())));
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } finally {
      last = null;
      replaceNext(null);
    }
  }

  private void serve(PreviewController stage) throws InterruptedException {
    long begun = System.nanoTime();
    long drawn = begun;
    while (!ended) {
      Consumer<PreviewController> what = next(stage, stage.live() ? begun + FRAME : drawn + REST);
      boolean wanted = what != null;
      boolean recent = System.nanoTime() - drawn < REST;
      try {
        while (what != null && !ended) {
          what.accept(stage);
          what = told.poll();
        }
        if (!ended) {
          long now = System.nanoTime();
          boolean hurried = wanted && (recent || stage.heavy());
          Optional<PreviewFrame> frame = stage.frame((now - begun) * 1e-9, hurried);
          animation = stage.animation();
          frame.ifPresent(listener::drawn);
          pose = stage.pose();
          begun = now;
          drawn = System.nanoTime();
        }
      } catch (
          RuntimeException e) { // One state of a document must not end the preview of the next.
        listener.failed(Texts.of("preview.cannot", e.toString()));
      }
    }
  }

  /** Waits for a command, at most until the next frame is due. */
  private @Nullable Consumer<PreviewController> next(PreviewController stage, long due)
      throws InterruptedException {
    if (!stage.live() && !stage.rough()) {
      return told.take();
    }
    long left = due - System.nanoTime();
    return left > 0 ? told.poll(left, TimeUnit.NANOSECONDS) : told.poll();
  }

  /** Ends the thread after its present command. */
  @Override
  public void close() {
    ended = true;
    tell(stage -> {});
  }
}
