package org.selectiverenderer.enricher.preview;

import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import org.selectiverenderer.document.DocumentListener;
import org.selectiverenderer.document.SceneDocument;
import org.selectiverenderer.document.Snapshot;
import org.selectiverenderer.x3d.files.ContentAccess;

/**
 * Loads the document as it is now, saved or not, after every pause in editing. For the event
 * dispatch thread; reads on the thread {@code enricher-preview-loader}. A state that is overtaken
 * by the next while it is read is dropped.
 */
final class SceneFeed implements AutoCloseable {
  /** Hears how it goes, on the event dispatch thread. */
  interface Listener {
    void loading();

    void loaded();

    /** The document cannot be shown as it is now; a sentence. */
    void stale(String sentence);
  }

  /** Milliseconds without an edit before the scene is read anew. */
  private static final int PAUSE = 400;

  private final SceneDocument document;
  private final Supplier<Path> file;
  private final ContentAccess access;
  private final Consumer<LoadedPreview> target;
  private final Listener listener;
  private final DocumentListener onChange = change -> later();
  private final Timer timer = new Timer(PAUSE, event -> now());
  private final AtomicLong wanted = new AtomicLong();
  private final ExecutorService reader =
      Executors.newSingleThreadExecutor(
          task -> {
            Thread thread = new Thread(task, "enricher-preview-loader");
            thread.setDaemon(true);
            return thread;
          });

  /**
   * @param file where the document is saved: its folder is that of relative urls
   * @param access what it may name besides its own files
   * @param target takes each state over, on the loader's thread
   */
  SceneFeed(
      SceneDocument document,
      Supplier<Path> file,
      ContentAccess access,
      Consumer<LoadedPreview> target,
      Listener listener) {
    this.document = document;
    this.file = file;
    this.access = access;
    this.target = target;
    this.listener = listener;
    timer.setRepeats(false);
    document.addListener(onChange);
  }

  private void later() {
    wanted.incrementAndGet();
    timer.restart();
  }

  /** Loads without waiting for a pause. */
  void now() {
    long mine = wanted.incrementAndGet();
    if (document.fault().isPresent()) {
      var fault = document.fault().get();
      listener.stale(
          "Line %d is not well formed; the preview does not change until you correct it"
              .formatted(fault.location().line()));
      return;
    }
    listener.loading();
    Snapshot snapshot = document.snapshot();
    Path path = file.get().toAbsolutePath();
    Path folder = path.getParent() == null ? path : path.getParent();
    reader.execute(() -> load(mine, snapshot, folder));
  }

  private void load(long mine, Snapshot snapshot, Path folder) {
    if (wanted.get() != mine) {
      return;
    }
    try {
      LoadedPreview loaded = LoadedPreview.of(snapshot, folder, access);
      if (wanted.get() == mine) {
        target.accept(loaded);
        tell(mine, listener::loaded);
      } else {
        loaded.close();
      }
    } catch (IOException e) {
      tell(mine, () -> listener.stale("The preview cannot show the scene: " + e.getMessage()));
    } catch (RuntimeException e) {
      tell(mine, () -> listener.stale("The preview cannot show the scene: " + e));
    }
  }

  private void tell(long mine, Runnable what) {
    SwingUtilities.invokeLater(
        () -> {
          if (wanted.get() == mine) {
            what.run();
          }
        });
  }

  @Override
  public void close() {
    document.removeListener(onChange);
    timer.stop();
    wanted.incrementAndGet();
    reader.shutdown();
  }
}
