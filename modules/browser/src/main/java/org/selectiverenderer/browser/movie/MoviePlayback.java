package org.selectiverenderer.browser.movie;

import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;

/**
 * The playback of a movie. The stepping thread sets the time, the drawing thread gets the frame.
 * Another thread decodes the frame wanted and a few ahead; until it is ready, the last frame stays
 * visible. A short movie is decoded once and kept. Thread-safe.
 */
public final class MoviePlayback {
  private static final int AHEAD = 3;

  /**
   * Number of frames that are kept however large they are: the visible one, the next, and those
   * decoded ahead.
   */
  private static final int LEAST = AHEAD + 2;

  /** Seconds after which a thread that waits for a frame gets the last one available. */
  private static final long PATIENCE = 20;

  /**
   * The visible frame; the same object until another frame is shown.
   *
   * @param rgba four bytes r, g, b, a per pixel; the first row is the lowest
   */
  public record Picture(int width, int height, byte[] rgba) {}

  private final Movie movie;
  private final MovieDecoderPool room;
  private final Picture first;

  // Guarded by this:
  private final Map<Integer, Picture> ready = new LinkedHashMap<>();
  private Picture shown;
  private int wanted;
  private int direction = 1;
  private boolean turned = true;
  private boolean working;
  private @Nullable String fault;
  private boolean damaged;

  // Used by the decoding thread only, one at a time.
  private Movie.@Nullable Pictures pictures;

  MoviePlayback(Movie movie, byte[] first, MovieDecoderPool room) {
    this.movie = movie;
    this.room = room;
    this.first = new Picture(movie.width(), movie.height(), first);
    shown = this.first;
    ready.put(0, shown);
  }

  /** Returns a second playback of the same movie, from its beginning. */
  public MoviePlayback anew() {
    return room.film(movie, first.rgba());
  }

  /** Returns the duration in seconds at normal speed. */
  public double seconds() {
    return movie.seconds();
  }

  /**
   * Sets the playback time.
   *
   * @param seconds the time from the beginning of the movie
   * @param backwards whether the movie plays backwards
   */
  public synchronized void stand(double seconds, boolean backwards) {
    wanted = movie.at(seconds);
    direction = backwards ? -1 : 1;
    turned = true;
  }

  /** Starts a new frame of the scene; within it every eye sees the same movie frame. */
  public synchronized void nextFrame() {
    turned = true;
  }

  /**
   * Returns the movie frame at the playback time, or the nearest one before it, and requests
   * decoding of the next ones.
   */
  public synchronized Picture picture() {
    if (!turned) {
      return shown;
    }
    turned = false;
    if (!ready.containsKey(wanted) || missing() >= 0) {
      work();
    }
    if (room.patient()) {
      await();
    }
    shown = nearest();
    return shown;
  }

  /** Returns why decoding has stopped, as a clause that follows the file's name; reported once. */
  public synchronized Optional<String> fault() {
    Optional<String> told = Optional.ofNullable(fault);
    fault = null;
    return told;
  }

  private void work() {
    if (!working && !damaged && !room.closed()) {
      working = true;
      room.threads().execute(this::decode);
    }
  }

  private void await() {
    long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE);
    try {
      while (working && !ready.containsKey(wanted)) {
        long left = TimeUnit.NANOSECONDS.toMillis(end - System.nanoTime());
        if (left <= 0) {
          return;
        }
        wait(left);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Returns the last decoded frame before the playback time, in the direction of play. */
  private Picture nearest() {
    Picture exact = ready.get(wanted);
    if (exact != null) {
      return exact;
    }
    Picture best = shown;
    int least = movie.pictures();
    for (Map.Entry<Integer, Picture> one : ready.entrySet()) {
      int behind = Math.floorMod(direction * (wanted - one.getKey()), movie.pictures());
      if (behind < least) {
        least = behind;
        best = one.getValue();
      }
    }
    return best;
  }

  /**
   * Returns the index of the frame to be decoded next: the one wanted, or one ahead; -1 for none.
   */
  private int missing() {
    for (int i = 0; i <= AHEAD; i++) {
      int next = Math.floorMod(wanted + i * direction, movie.pictures());
      if (!ready.containsKey(next)) {
        return next;
      }
    }
    return -1;
  }

  private synchronized int next() {
    int next = missing();
    if (next < 0 || room.closed()) {
      working = false;
      notifyAll();
      return -1;
    }
    return next;
  }

  private void decode() {
    for (int next = next(); next >= 0; next = next()) {
      try {
        if (pictures == null) {
          pictures = movie.open();
        }
        arrived(next, pictures.picture(next));
      } catch (IOException e) {
        failed(e.getMessage());
        return;
      } catch (RuntimeException | OutOfMemoryError e) {
        // Otherwise the error would be lost: the pool swallows exceptions of its tasks.
        failed("cannot be decoded (%s)".formatted(e));
        return;
      }
    }
  }

  private synchronized void arrived(int number, byte[] rgba) {
    long most = Math.max(LEAST, room.share() / rgba.length);
    if (ready.size() >= most) {
      ready.keySet().removeIf(old -> ready.size() >= most && !soon(old));
    }
    ready.put(number, new Picture(movie.width(), movie.height(), rgba));
    notifyAll();
  }

  private boolean soon(int number) {
    return Math.floorMod(direction * (number - wanted), movie.pictures()) <= AHEAD;
  }

  private synchronized void failed(String why) {
    fault = why;
    damaged = true;
    working = false;
    notifyAll();
  }
}
