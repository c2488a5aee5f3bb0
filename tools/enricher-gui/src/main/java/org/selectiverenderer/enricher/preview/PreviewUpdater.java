package org.selectiverenderer.enricher.preview;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
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
 * Brings the preview up to date with the document, saved or not: by a patch where that is possible
 * ({@link SceneTextDiff}), at once if what has changed tells enough ({@link ChangedPart}), else
 * after a pause in editing by comparing or loading all of it. For the event dispatch thread;
 * compares and loads on the thread {@code enricher-preview-loader}. A state that is outdated while
 * it is being loaded is dropped.
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

  /** Holds what an edit has changed, in the text of its revision. */
  private record Edited(long revision, ChangedRange range) {}

  /** Milliseconds without an edit before a patch is tried of what a series of edits has changed. */
  private static final int SOON = 40;

  /** Milliseconds without an edit before the whole text is compared or loaded. */
  private static final int PAUSE = 400;

  private final SceneDocument document;
  private final Supplier<Path> file;
  private final Supplier<ContentAccessPolicy> access;
  private final Target target;
  private final Listener listener;
  private final DocumentListener onChange = this::later;
  private final Timer timer = new Timer(PAUSE, event -> follow());
  private final Timer soon = new Timer(SOON, event -> patchSoon());

  /** The time of the last change of the document, by {@link System#nanoTime}. */
  private long changed = System.nanoTime() - TimeUnit.MILLISECONDS.toNanos(SOON);

  /** The edits since the last state that was handed over. */
  private final Deque<Edited> edits = new ArrayDeque<>();

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
    soon.setRepeats(false);
    document.addListener(onChange);
  }

  private void later(DocumentListener.Change change) {
    wanted.incrementAndGet();
    if (change.changes().isEmpty()) {
      edits.clear();
      given.set(null);
    } else {
      edits.add(new Edited(change.revision(), ChangedRange.of(change)));
    }
    timer.restart();
    long now = System.nanoTime();
    boolean first = now - changed >= TimeUnit.MILLISECONDS.toNanos(SOON);
    changed = now;
    soon.setInitialDelay(first ? 0 : SOON); // Only of a series of edits it waits for the end.
    soon.restart();
  }

  /** Compares what has changed since the state that is shown, if that is a small part. */
  private void patchSoon() {
    Given before = given.get();
    edits.removeIf(edit -> before == null || edit.revision() <= before.snapshot().revision());
    Optional<ChangedRange> change = edits.stream().map(Edited::range).reduce(ChangedRange::and);
    if (before == null || change.isEmpty()) {
      return;
    }
    List<ChangedPart> parts = ChangedPart.of(document, change.get(), NodeCatalogue.load());
    if (parts.isEmpty()) {
      return;
    }
    long mine = wanted.get();
    DocumentSnapshot snapshot = document.snapshot();
    Path folder = folder();
    reader.execute(
        () -> {
          if (wanted.get() == mine && before.folder().equals(folder)) {
            parts.stream()
                .flatMap(part -> patch(before, snapshot, part).stream())
                .findFirst()
                .ifPresent(patch -> give(mine, before, new Given(snapshot, folder), patch));
          }
        });
  }

  private static Optional<ScenePatch> patch(
      Given before, DocumentSnapshot snapshot, ChangedPart part) {
    return SceneTextDiff.between(before.snapshot(), snapshot, part, NodeCatalogue.load());
  }

  /** Hands a patch over, unless its state is outdated; returns whether it is not. */
  private boolean give(long mine, Given before, Given state, ScenePatch patch) {
    boolean newest = given.compareAndSet(before, state);
    if (newest) {
      target.patch(patch, () -> SwingUtilities.invokeLater(this::now));
      tell(mine, listener::loaded);
    }
    return newest;
  }

  private Path folder() {
    Path path = file.get().toAbsolutePath();
    return path.getParent() == null ? path : path.getParent();
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
    soon.stop();
    long mine = wanted.incrementAndGet();
    if (document.fault().isPresent()) {
      var fault = document.fault().get();
      int line = fault.location().line();
      listener.stale(Texts.of("preview.fault", line, Integer.toString(line), fault.message()));
      return;
    }
    DocumentSnapshot snapshot = document.snapshot();
    Path folder = folder();
    reader.execute(() -> load(mine, snapshot, folder));
  }

  private void load(long mine, DocumentSnapshot snapshot, Path folder) {
    if (wanted.get() != mine) {
      return;
    }
    Given before = given.get();
    if (before != null && before.folder().equals(folder)) {
      if (before.snapshot().revision() == snapshot.revision()) {
        tell(mine, listener::loaded); // A patch has been handed over before the pause ended.
        return;
      }
      Optional<ScenePatch> patch =
          SceneTextDiff.between(before.snapshot(), snapshot, NodeCatalogue.load());
      if (patch.isPresent() && give(mine, before, new Given(snapshot, folder), patch.get())) {
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
    soon.stop();
    wanted.incrementAndGet();
    reader.shutdown();
  }
}
