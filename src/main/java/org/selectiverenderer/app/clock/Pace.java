package org.selectiverenderer.app.clock;

import java.util.OptionalDouble;
import org.selectiverenderer.app.settings.FollowedPath;
import org.selectiverenderer.app.settings.RunSettings;
import org.selectiverenderer.app.walk.Walking;
import org.selectiverenderer.runtime.World;
import org.selectiverenderer.runtime.viewer.PathMotion;
import org.selectiverenderer.runtime.viewer.ViewerMotion;

/**
 * The timing of a run: in real time before a user, or as fast as possible without one. It decides
 * the frame clock, what moves its viewer, and whether sounds are played.
 */
public enum Pace {
  /** In real time: a user watches, and navigates where no path is followed. */
  WATCHED {
    @Override
    public FrameClock clock(RunSettings settings, OptionalDouble replayed) {
      return settings
          .motion()
          .path()
          .map(path -> FrameSchedule.of(path, settings.duration()))
          .<FrameClock>map(schedule -> new WatchedFrames(schedule, settings.duration()))
          .orElseGet(() -> new WallFrames(settings.duration().orElse(Double.POSITIVE_INFINITY)));
    }

    @Override
    ViewerMotion unled(Walking walking) {
      return walking;
    }

    @Override
    public void begin(World world, RunSettings settings) {
      if (settings.motion().path().isEmpty()) {
        world.epoch(System.currentTimeMillis() / 1000.0);
      }
    }

    @Override
    public boolean audible() {
      return true;
    }

    @Override
    public boolean countsFromFirstPicture() {
      return false; // What is recorded of the head began with the first step.
    }
  },

  /** As fast as frames can be computed, with the same frames in every run; nobody navigates. */
  UNWATCHED {
    @Override
    public FrameClock clock(RunSettings settings, OptionalDouble replayed) {
      if (settings.motion().path().isPresent()) {
        return new ScheduledFrames(
            FrameSchedule.of(settings.motion().path().get(), settings.duration()));
      }
      if (replayed.isPresent()) {
        double end = settings.duration().orElse(replayed.getAsDouble());
        return new ScheduledFrames(new EvenFrames(0, end, FollowedPath.RATE));
      }
      return new WallFrames(settings.duration().orElse(0));
    }

    @Override
    ViewerMotion unled(Walking walking) {
      return (viewer, time, dt) -> {};
    }

    @Override
    public void begin(World world, RunSettings settings) {
      // The world's own epoch is the same every time.
    }

    @Override
    public boolean audible() {
      return false;
    }

    @Override
    public boolean countsFromFirstPicture() {
      return true; // A duration is that of pictures, however long the first one takes.
    }
  };

  /**
   * Creates the frame clock of a run.
   *
   * @param replayed the length in seconds of the tracker log that is replayed; empty for none
   */
  public abstract FrameClock clock(RunSettings settings, OptionalDouble replayed);

  /** Sets the start time of a world before its first frame. */
  public abstract void begin(World world, RunSettings settings);

  /**
   * Returns whether time counts from the moment at which the first picture is drawn, not from the
   * moment at which its frame is stepped.
   */
  public abstract boolean countsFromFirstPicture();

  /** Returns whether sounds are played; they need real time. */
  public abstract boolean audible();

  /** Returns what moves the viewer where no path is followed. */
  abstract ViewerMotion unled(Walking walking);

  /**
   * Returns what moves the viewer, before a tracker turns it.
   *
   * @param walking the user's navigation
   */
  public ViewerMotion motion(RunSettings settings, Walking walking) {
    return settings
        .motion()
        .path()
        .<ViewerMotion>map(followed -> new PathMotion(followed.path(), 0))
        .orElseGet(() -> unled(walking));
  }
}
