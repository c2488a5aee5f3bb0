package org.selectiverenderer.app.clock;

import java.util.OptionalDouble;
import org.selectiverenderer.app.settings.FollowedPath;
import org.selectiverenderer.app.settings.RunSettings;
import org.selectiverenderer.app.walk.Walking;
import org.selectiverenderer.runtime.World;
import org.selectiverenderer.runtime.viewer.PathMotion;
import org.selectiverenderer.runtime.viewer.ViewerMotion;

/** How a run goes on from frame to frame, and what moves its viewer. */
public enum Pace {
  /** As the clock on the wall goes: somebody looks, and walks where no path is followed. */
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

  /** As fast as frames come, with the same frames every time; nobody walks. */
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
   * The frames of a run.
   *
   * @param replayed seconds of the tracker's log that is played again; empty for none
   */
  public abstract FrameClock clock(RunSettings settings, OptionalDouble replayed);

  /** Sets the clock of a scene, before its first frame. */
  public abstract void begin(World world, RunSettings settings);

  /** Whether time begins when the first picture is drawn, not when its frame is stepped. */
  public abstract boolean countsFromFirstPicture();

  /** Whether sounds are heard: they take the time that they take. */
  public abstract boolean audible();

  /** What moves the viewer where no path is followed. */
  abstract ViewerMotion unled(Walking walking);

  /**
   * What moves the viewer, before a tracker turns it.
   *
   * @param walking the user's
   */
  public ViewerMotion motion(RunSettings settings, Walking walking) {
    return settings
        .motion()
        .path()
        .<ViewerMotion>map(followed -> new PathMotion(followed.path(), 0))
        .orElseGet(() -> unled(walking));
  }
}
