package org.selectiverenderer.runtime.movie;

import java.util.Collections;
import java.util.Map;
import java.util.WeakHashMap;
import java.util.concurrent.Executor;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;

/**
 * Where films are decoded: threads {@code movie-N}, which begin with the first picture and end when
 * none has been wanted for two seconds. Thread-safe.
 */
public final class ProjectionRoom implements AutoCloseable {
  /** Bytes of pictures that a film keeps at most, unless they are few. */
  private static final long KEPT = 24 << 20;

  private final ThreadPoolExecutor threads;
  private final Map<Film, Boolean> films = Collections.synchronizedMap(new WeakHashMap<>());
  private volatile boolean patient;
  private volatile boolean closed;

  public ProjectionRoom() {
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
            new ThreadPoolExecutor.DiscardPolicy()); // Closed: nobody looks any more.
    threads.allowCoreThreadTimeOut(true);
  }

  /**
   * Has whoever asks for a picture wait for it. Where times are not those of a clock, what is seen
   * must not depend on how fast this machine decodes.
   */
  public void waitForPictures() {
    patient = true;
  }

  /** A film of this room. */
  public Film film(Movie movie, byte[] first) {
    Film film = new Film(movie, first, this);
    films.put(film, true);
    return film;
  }

  /** Bytes of pictures that a film may keep: all together an eighth of the memory. */
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

  /** Nothing more is decoded; what is under way ends with its picture. */
  @Override
  public void close() {
    closed = true;
    threads.shutdown();
  }
}
