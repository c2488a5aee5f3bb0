package org.selectiverenderer.enricher.preview;

import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.SwingUtilities;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.instance.Background;
import org.selectiverenderer.browser.instance.VisibleBoundsCalculator;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.render.AntiAliasing;
import org.selectiverenderer.render.context.GlUnavailableException;
import org.selectiverenderer.render.preview.PreviewImage;
import org.selectiverenderer.render.preview.PreviewOptions;
import org.selectiverenderer.render.preview.ScenePreviewRenderer;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;

/**
 * Renders small pictures of versions for forms and dialogs, one after the other on the thread
 * {@code version-pictures}, which starts with the first request. Pictures are cached until the file
 * changes or many others have been requested.
 *
 * <p>{@link #request} is for the event dispatch thread, on which the answers come too.
 */
public final class VersionImageRenderer implements AutoCloseable {
  /** A pending request. */
  public interface Request {
    /** Cancels the request; no answer will come. For the event dispatch thread. */
    void cancel();
  }

  private static final int KEPT = 400;
  private static final float GREY = 0.82f;
  private static final Background PAPER =
      new Background(new float[] {GREY, GREY, GREY}, new float[0], new float[0], new float[0], 0);

  private record Key(VersionSource source, Object state, VersionImageSpec look) {}

  private record Job(
      VersionSource source,
      VersionImageSpec look,
      Consumer<VersionImage> taken,
      Consumer<String> failed,
      State state) {}

  private static final class State implements Request {
    private volatile boolean cancelled;

    @Override
    public void cancel() {
      cancelled = true;
    }
  }

  private final LinkedBlockingQueue<Optional<Job>> jobs = new LinkedBlockingQueue<>();
  private final Map<Key, VersionImage> kept =
      new LinkedHashMap<>(16, 0.75f, true) {
        private static final long serialVersionUID = 1L;

        @Override
        protected boolean removeEldestEntry(Map.Entry<Key, VersionImage> eldest) {
          return size() > KEPT;
        }
      };
  private final Supplier<ContentAccessPolicy> access;
  private final OrbitCamera orbit = new OrbitCamera();
  private @Nullable Thread thread;
  private @Nullable LoadedPreview last;
  private @Nullable Object lastState;
  private @Nullable VersionSource lastSource;
  private volatile boolean closed;

  /** Renders scenes that may read no other than their own files. */
  public VersionImageRenderer() {
    this(ContentAccessPolicy::none);
  }

  /**
   * @param access folders and hosts that scenes may read from
   */
  public VersionImageRenderer(Supplier<ContentAccessPolicy> access) {
    this.access = access;
  }

  /**
   * Requests a picture.
   *
   * @param taken called with the picture, on the event dispatch thread
   * @param failed called with a sentence why there is none, on the event dispatch thread
   */
  public Request request(
      VersionSource source,
      VersionImageSpec look,
      Consumer<VersionImage> taken,
      Consumer<String> failed) {
    State state = new State();
    if (closed) {
      state.cancel();
      return state;
    }
    jobs.add(Optional.of(new Job(source, look, taken, failed, state)));
    if (thread == null) {
      thread = new Thread(this::run, "version-pictures");
      thread.setDaemon(true);
      thread.start();
    }
    return state;
  }

  private void run() {
    try (ScenePreviewRenderer view = ScenePreviewRenderer.open()) {
      serve(job -> picture(view, job));
    } catch (GlUnavailableException e) {
      refuse(Texts.of("preview.nopictures", String.valueOf(e.getMessage())));
    } finally {
      forget();
    }
  }

  /** Answers all requests with the same sentence. */
  private void refuse(String sentence) {
    serve(
        job -> {
          throw new IOException(sentence);
        });
  }

  private interface Taking {
    VersionImage take(Job job) throws IOException;
  }

  private void serve(Taking taking) {
    try {
      while (!closed) {
        Optional<Job> next = jobs.take();
        if (next.isPresent() && !next.get().state().cancelled) {
          answer(next.get(), taking);
        }
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private void answer(Job job, Taking taking) {
    try {
      VersionImage picture = taking.take(job);
      tell(job, () -> job.taken().accept(picture));
    } catch (IOException e) {
      tell(job, () -> job.failed().accept(sentence(e)));
    } catch (GlUnavailableException e) {
      tell(
          job,
          () -> job.failed().accept(Texts.of("preview.nopicture", String.valueOf(e.getMessage()))));
    } catch (RuntimeException e) { // A faulty model must not stop the pictures of others.
      tell(job, () -> job.failed().accept(Texts.of("preview.nomodel", e.toString())));
    }
  }

  private static String sentence(IOException e) {
    String message = e.getMessage();
    return message == null || message.isBlank() ? Texts.of("preview.unread") : message;
  }

  private void tell(Job job, Runnable what) {
    SwingUtilities.invokeLater(
        () -> {
          if (!job.state().cancelled && !closed) {
            what.run();
          }
        });
  }

  private VersionImage picture(ScenePreviewRenderer view, Job job) throws IOException {
    Object state = job.source().state();
    Key key = new Key(job.source(), state, job.look());
    VersionImage known = kept.get(key);
    if (known == null) {
      known = take(view, load(job.source(), state), job.look());
      kept.put(key, known);
    }
    return known;
  }

  /** Loads a model; keeps the last one, as solid and wireframe pictures are requested together. */
  private LoadedPreview load(VersionSource source, Object state) throws IOException {
    if (last == null || !source.equals(lastSource) || !state.equals(lastState)) {
      forget();
      last = LoadedPreview.of(source.name(), source.bytes(), source.folder(), access.get(), 0);
      lastSource = source;
      lastState = state;
    }
    return last;
  }

  private void forget() {
    if (last != null) {
      last.close();
      last = null;
    }
  }

  private VersionImage take(ScenePreviewRenderer view, LoadedPreview model, VersionImageSpec look) {
    var world = model.world();
    orbit.face(look.yaw(), look.pitch());
    VisibleBoundsCalculator.of(world.instances().shapes()).ifPresent(orbit::frame);
    world.step(0, (viewer, now, dt) -> orbit.pose().applyTo(viewer));
    PreviewImage picture =
        view.draw(
            world,
            new PreviewOptions(List.of(), Set.of(), look.wireframe(), Optional.of(PAPER)),
            look.width(),
            look.height(),
            AntiAliasing.SMOOTH);
    return new VersionImage(
        ScreenshotConverter.of(picture.pixels()), world.instances().shownPolygons());
  }

  /** Ends its thread; no answer comes any more. */
  @Override
  public void close() {
    closed = true;
    jobs.add(Optional.empty());
  }
}
