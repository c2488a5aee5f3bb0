package org.selectiverenderer.enricher.preview;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Supplier;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.authoring.DocumentListener;
import org.selectiverenderer.authoring.DocumentSnapshot;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;

/**
 * Brings the preview up to date with the document, saved or not, after every pause in editing: by a
 * patch where that is possible ({@link SceneTextDiff}), else by loading all of it. For the event
 * dispatch thread; loads on the thread {@code enricher-preview-loader}. A state that is outdated
 * while it is being loaded is dropped.
 */
final class PreviewUpdater implements AutoCloseable {
  /** Receives the progress of loading, on the event dispatch thread. */
  interface Listener {
    void loading();

    void loaded();

    /** The present document cannot be shown; the sentence says why. */
    void stale(String sentence);
  }

  /** Receives the states of the document, on the loader's thread. */
  interface Target {
    void show(LoadedPreview loaded);

    /**
     * Receives what has changed since the previous state.
     *
     * @param refused runs, on any thread, if the patch does not apply
     */
    void patch(ScenePatch patch, Runnable refused);
  }

  /** A state that has been handed over, and the base folder of its urls. */
  private record Given(DocumentSnapshot snapshot, Path folder) {}

  /** Milliseconds without an edit before the preview is updated. */
  private static final int PAUSE = 400;

  private final SceneDocument document;
  private final Supplier<Path> file;
  private final Supplier<ContentAccessPolicy> access;
  private final Target target;
  private final Listener listener;
  private final DocumentListener onChange = change -> later();
  private final Timer timer = new Timer(PAUSE, event -> follow());
  private final AtomicLong wanted = new AtomicLong();

  /** The last state handed over; null where the next one has to be loaded as a whole. */
  private final AtomicReference<@Nullable Given> given = new AtomicReference<>();

  private final ExecutorService reader =
      Executors.newSingleThreadExecutor(
          task -> {
            Thread thread = new Thread(task, "enricher-preview-loader");
            thread.setDaemon(true);
            return thread;
          });

  /**
   * @param file the document's file, whose folder is the base of relative urls
   * @param access folders and hosts that the scene may read from; asked on the loader's thread
   * @param target receives each state
   */
  PreviewUpdater(
      SceneDocument document,
      Supplier<Path> file,
      Supplier<ContentAccessPolicy> access,
      Target target,
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

  /** Loads the whole document, without waiting for a pause. */
  void now() {
    synchronized (given) {
      given.set(null);
      wanted.incrementAndGet(); // Outdates what is being loaded.
    }
    follow();
  }

  private void follow() {
    long mine = wanted.incrementAndGet();
    if (document.fault().isPresent()) {
      var fault = document.fault().get();
      int line = fault.location().line();
      listener.stale(Texts.of("preview.fault", line, Integer.toString(line), fault.message()));
      return;
    }
    DocumentSnapshot snapshot = document.snapshot();
    Path path = file.get().toAbsolutePath();
    Path folder = path.getParent() == null ? path : path.getParent();
    reader.execute(() -> load(mine, snapshot, folder));
  }

  private void load(long mine, DocumentSnapshot snapshot, Path folder) {
    if (wanted.get() != mine) {
      return;
    }
    Given before = given.get();
    if (before != null && before.folder().equals(folder)) {
      Optional<ScenePatch> patch =
          SceneTextDiff.between(before.snapshot(), snapshot, NodeCatalogue.load());
      if (patch.isPresent() && given.compareAndSet(before, new Given(snapshot, folder))) {
        target.patch(patch.get(), () -> SwingUtilities.invokeLater(this::now));
        tell(mine, listener::loaded);
        return;
      }
    }
    tell(mine, listener::loading);
    try {
      LoadedPreview loaded = LoadedPreview.of(snapshot, folder, access.get());
      if (gave(mine, new Given(snapshot, folder))) {
        target.show(loaded);
        tell(mine, listener::loaded);
      } else {
        loaded.close();
      }
    } catch (IOException e) {
      tell(mine, () -> listener.stale(Texts.of("preview.noscene", String.valueOf(e.getMessage()))));
    } catch (RuntimeException e) {
      tell(mine, () -> listener.stale(Texts.of("preview.noscene", e.toString())));
    }
  }

  /** Records a state as handed over, unless it is outdated; returns whether it is not. */
  private boolean gave(long mine, Given state) {
    synchronized (given) {
      boolean newest = wanted.get() == mine;
      if (newest) {
        given.set(state);
      }
      return newest;
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
