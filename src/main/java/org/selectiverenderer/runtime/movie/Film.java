package org.selectiverenderer.runtime.movie;

import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;

/**
 * A movie that is shown. The thread that steps the scene says where it stands, the one that draws
 * asks for the picture. What is asked for is decoded on another thread, with a few that come next;
 * until it is there, one sees what came last. A short film is decoded once and kept. Thread-safe.
 */
public final class Film {
  private static final int AHEAD = 3;

  /** Pictures that are kept however large they are: one is seen, one comes, others are ahead. */
  private static final int LEAST = AHEAD + 2;

  /** Seconds after which whoever waits for a picture gets what there is. */
  private static final long PATIENCE = 20;

  /**
   * What is seen; the same object until another one is.
   *
   * @param rgba four bytes r, g, b, a per pixel; the first row is the lowest
   */
  public record Picture(int width, int height, byte[] rgba) {}

  private final Movie movie;
  private final ProjectionRoom room;
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

  // Of the thread that decodes; one at a time.
  private Movie.@Nullable Pictures pictures;

  Film(Movie movie, byte[] first, ProjectionRoom room) {
    this.movie = movie;
    this.room = room;
    this.first = new Picture(movie.width(), movie.height(), first);
    shown = this.first;
    ready.put(0, shown);
  }

  /** The same movie, to be shown apart from this one, from its beginning. */
  public Film anew() {
    return room.film(movie, first.rgba());
  }

  /** How long it takes at its own speed. */
  public double seconds() {
    return movie.seconds();
  }

  /**
   * Takes it to a time.
   *
   * @param seconds from the beginning of the movie
   * @param backwards whether it runs that way
   */
  public synchronized void stand(double seconds, boolean backwards) {
    wanted = movie.at(seconds);
    direction = backwards ? -1 : 1;
    turned = true;
  }

  /** The scene has gone on by a frame, in which the same picture is seen by every eye. */
  public synchronized void nextFrame() {
    turned = true;
  }

  /** The picture of where it stands, or the nearest before that; has the next ones decoded. */
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

  /** Why it goes on no longer, in a clause that reads after the file's name; told once. */
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

  /** Of what is ready, what comes last before where it stands, the way it runs. */
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

  /** What is to be decoded next: what is wanted, or comes soon; -1 for nothing. */
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
        // Else nobody would hear of it: the pool keeps what its tasks throw to itself.
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
