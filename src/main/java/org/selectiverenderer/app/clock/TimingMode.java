package org.selectiverenderer.app.clock;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.selectiverenderer.app.settings.PathPlaybackSettings;
import org.selectiverenderer.app.settings.RunSettings;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.viewer.PathMotion;
import org.selectiverenderer.browser.viewer.ViewerMotion;
import org.selectiverenderer.walkthrough.NavigationController;

/**
 * The timing of a run: in real time before a user, or as fast as possible without one. It decides
 * the frame clock, what moves its viewer, and whether sounds are played.
 */
public enum TimingMode {
  /** In real time: a user watches, and navigates where no path is followed. */
  WATCHED {
    @Override
    public FrameClock clock(RunSettings settings, OptionalDouble replayed) {
      return settings
          .motion()
          .path()
          .map(path -> FrameSchedule.of(path, settings.duration()))
          .<FrameClock>map(schedule -> new RealTimeScheduleClock(schedule, settings.duration()))
          .orElseGet(() -> new WallClock(settings.duration().orElse(Double.POSITIVE_INFINITY)));
    }

    @Override
    ViewerMotion unled(NavigationController walking) {
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
        return new ScheduleClock(
            FrameSchedule.of(settings.motion().path().get(), settings.duration()));
      }
      if (replayed.isPresent()) {
        double end = settings.duration().orElse(replayed.getAsDouble());
        return new ScheduleClock(new FixedRateSchedule(0, end, PathPlaybackSettings.RATE));
      }
      return new WallClock(settings.duration().orElse(0));
    }

    @Override
    ViewerMotion unled(NavigationController walking) {
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
  abstract ViewerMotion unled(NavigationController walking);

  /**
   * Returns what moves the viewer, before a tracker turns it.
   *
   * @param walking the user's navigation
   */
  public ViewerMotion motion(RunSettings settings, NavigationController walking) {
    return settings
        .motion()
        .path()
        .<ViewerMotion>map(followed -> new PathMotion(followed.path(), 0))
        .orElseGet(() -> unled(walking));
  }

  /**
   * A frame clock that takes one frame of a schedule for each picture, however long a picture
   * takes.
   */
  private static final class ScheduleClock implements FrameClock {
    private final FrameSchedule schedule;
    private long next;

    ScheduleClock(FrameSchedule schedule) {
      this.schedule = schedule;
    }

    @Override
    public List<Double> due(double elapsed) {
      return List.of(schedule.time(next++));
    }

    @Override
    public boolean over(double elapsed) {
      return !schedule.has(next);
    }
  }

  /**
   * A frame clock with one frame for each picture, at the real time that has elapsed; it has at
   * least one frame.
   *
   * @param duration seconds after which the run ends; infinite for no end
   */
  private record WallClock(double duration) implements FrameClock {
    @Override
    public List<Double> due(double elapsed) {
      return List.of(elapsed);
    }

    @Override
    public boolean over(double elapsed) {
      return elapsed >= duration;
    }
  }

  /**
   * A frame clock that takes the frames of a schedule in real time. All frames are stepped; of the
   * frames that become due during one slow picture only the last is drawn.
   */
  private static final class RealTimeScheduleClock implements FrameClock {
    private final FrameSchedule schedule;
    private final OptionalDouble duration;
    private long next;

    /**
     * @param duration seconds after which the clock is over; empty for the end of the schedule
     */
    RealTimeScheduleClock(FrameSchedule schedule, OptionalDouble duration) {
      this.schedule = schedule;
      this.duration = duration;
    }

    @Override
    public List<Double> due(double elapsed) {
      List<Double> due = new ArrayList<>();
      double start = schedule.time(0);
      while (schedule.has(next) && schedule.time(next) - start <= elapsed) {
        due.add(schedule.time(next++));
      }
      return due;
    }

    @Override
    public boolean over(double elapsed) {
      return duration.isPresent() ? elapsed >= duration.getAsDouble() : !schedule.has(next);
    }
  }
}
