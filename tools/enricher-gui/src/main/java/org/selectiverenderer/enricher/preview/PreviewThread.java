package org.selectiverenderer.enricher.preview;

import java.util.Optional;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.runtime.render.context.GlUnavailableException;
import org.selectiverenderer.runtime.render.mark.MarkedView;
import org.selectiverenderer.runtime.viewer.Pose;

/**
 * The thread {@code enricher-preview}: owns the GL context and the running scene, does what it is
 * told in order, and draws when something has changed, or thirty times a second while the author
 * walks.
 */
final class PreviewThread implements AutoCloseable, SceneFeed.Target {
  /** Hears what comes of it, on the preview's thread. */
  interface Listener {
    void drawn(PreviewFrame frame);

    /**
     * The preview cannot show something.
     *
     * @param sentence what and why
     */
    void failed(String sentence);
  }

  /** Frames that follow each other faster may be rough; after this time a smooth one follows. */
  private static final long REST = TimeUnit.MILLISECONDS.toNanos(250);

  private static final long FRAME = TimeUnit.SECONDS.toNanos(1) / 30;

  private final LinkedBlockingQueue<Consumer<PreviewStage>> told = new LinkedBlockingQueue<>();
  private final AtomicReference<@Nullable LoadedPreview> next = new AtomicReference<>();
  private final Listener listener;
  private final Thread thread;
  private volatile boolean ended;
  private volatile Optional<Pose> pose = Optional.empty();

  PreviewThread(Listener listener) {
    this.listener = listener;
    thread = new Thread(this::run, "enricher-preview");
    thread.setDaemon(true);
    thread.start();
  }

  /** Does something to the stage, after which it is drawn. Thread-safe. */
  void tell(Consumer<PreviewStage> what) {
    ask(
        stage -> {
          what.accept(stage);
          stage.changed();
        });
  }

  /** Does something to the stage, which knows whether it is to be drawn. Thread-safe. */
  void ask(Consumer<PreviewStage> what) {
    told.add(what);
  }

  /**
   * Hands over what has changed of the scene that is shown. Thread-safe.
   *
   * @param refused hears, on this thread, if all is to be loaded instead
   */
  @Override
  public void patch(ScenePatch patch, Runnable refused) {
    ask(
        stage -> {
          if (!stage.patch(patch)) {
            refused.run();
          }
        });
  }

  /** Whether there is a preview: not where there is no OpenGL, nor after the end. Thread-safe. */
  boolean alive() {
    return thread.isAlive();
  }

  /** Where the picture drawn last was seen from; empty before the first. Thread-safe. */
  Optional<Pose> pose() {
    return pose;
  }

  /** Hands a scene over, in place of one that has not been shown yet. Thread-safe. */
  @Override
  public void show(LoadedPreview loaded) {
    replaceNext(loaded);
    tell(
        stage -> {
          LoadedPreview newest = next.getAndSet(null);
          if (newest != null) {
            stage.show(newest);
          }
        });
    if (!thread.isAlive()) {
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
    try (MarkedView view = MarkedView.open();
        PreviewStage stage = new PreviewStage(view)) {
      serve(stage);
    } catch (GlUnavailableException e) {
      listener.failed(Texts.of("preview.none", String.valueOf(e.getMessage())));
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } finally {
      replaceNext(null);
    }
  }

  private void serve(PreviewStage stage) throws InterruptedException {
    long begun = System.nanoTime();
    long drawn = begun;
    while (!ended) {
      Consumer<PreviewStage> what = next(stage, stage.moving() ? begun + FRAME : drawn + REST);
      boolean hurried = what != null && System.nanoTime() - drawn < REST;
      try {
        while (what != null && !ended) {
          what.accept(stage);
          what = told.poll();
        }
        if (!ended) {
          long now = System.nanoTime();
          stage.frame((now - begun) * 1e-9, hurried).ifPresent(listener::drawn);
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

  /** Waits for something to do, at most until the next frame is due where one is. */
  private @Nullable Consumer<PreviewStage> next(PreviewStage stage, long due)
      throws InterruptedException {
    if (!stage.moving() && !stage.rough()) {
      return told.take();
    }
    long left = due - System.nanoTime();
    return left > 0 ? told.poll(left, TimeUnit.NANOSECONDS) : told.poll();
  }

  /** Ends the thread after what it is doing now. */
  @Override
  public void close() {
    ended = true;
    tell(stage -> {});
  }
}
