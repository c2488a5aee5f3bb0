package org.selectiverenderer.browser.movie;

import java.util.Collections;
import java.util.Map;
import java.util.WeakHashMap;
import java.util.concurrent.Executor;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;

/**
 * The threads that decode movies, {@code movie-N}. They start with the first frame and end when
 * none has been requested for two seconds. Thread-safe.
 */
public final class MovieDecoderPool implements AutoCloseable {
  /**
   * Largest memory for the decoded frames of one movie, in bytes, unless a few frames need more.
   */
  private static final long KEPT = 24 << 20;

  private final ThreadPoolExecutor threads;
  private final Map<MoviePlayback, Boolean> films =
      Collections.synchronizedMap(new WeakHashMap<>());
  private volatile boolean patient;
  private volatile boolean closed;

  public MovieDecoderPool() {
    AtomicInteger count = new AtomicInteger();
    int most = Math.max(1, Runtime.getRuntime().availableProcessors() / 2);
    threads =
        new ThreadPoolExecutor(
            most,
            most,
            2,
            TimeUnit.SECONDS,
            new LinkedBlockingQueue<>(),
            task -> {
              Thread thread = new Thread(task, "movie-" + count.incrementAndGet());
              thread.setDaemon(true);
              return thread;
            },
            new ThreadPoolExecutor.DiscardPolicy()); // Closed: nobody needs the frame.
    threads.allowCoreThreadTimeOut(true);
  }

  /**
   * Makes threads that request a frame wait for it. Where frame times do not come from a clock, the
   * picture must not depend on how fast this machine decodes.
   */
  public void waitForPictures() {
    patient = true;
  }

  /** Makes a playback whose frames these threads decode. */
  public MoviePlayback film(Movie movie, byte[] first) {
    MoviePlayback film = new MoviePlayback(movie, first, this);
    films.put(film, true);
    return film;
  }

  /**
   * Returns the bytes of decoded frames that each movie may keep: all together an eighth of the
   * heap.
   */
  long share() {
    return Math.min(KEPT, Runtime.getRuntime().maxMemory() / 8 / Math.max(1, films.size()));
  }

  boolean patient() {
    return patient;
  }

  boolean closed() {
    return closed;
  }

  Executor threads() {
    return threads;
  }

  /** Stops decoding after the frames in progress. */
  @Override
  public void close() {
    closed = true;
    threads.shutdown();
  }
}
