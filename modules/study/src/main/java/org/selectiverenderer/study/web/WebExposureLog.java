package org.selectiverenderer.study.web;

import java.util.List;

/**
 * A page logged this of an exposure.
 *
 * @param frames in order of time, at least one
 * @param events what areas and objects did, in order of time
 */
public record WebExposureLog(List<Frame> frames, List<SceneEvent> events) {
  public WebExposureLog {
    frames = List.copyOf(frames);
    events = List.copyOf(events);
  }

  /**
   * A frame: the pose of the head, and when it was shown.
   *
   * @param t seconds since the exposure began
   * @param x of the point between the eyes, in world coordinates
   * @param y of that point
   * @param z of that point
   * @param yaw degrees about Y, positive to the left
   * @param pitch degrees about X, positive up
   * @param roll degrees about Z, positive to the left shoulder
   * @param ms milliseconds since the frame before
   * @param visible whether the picture was at least half as bright as without fading
   * @param mono seconds by the page's monotonic clock
   */
  public record Frame(
      double t,
      double x,
      double y,
      double z,
      double yaw,
      double pitch,
      double roll,
      double ms,
      boolean visible,
      double mono) {}

  /**
   * An event of the scene.
   *
   * @param t seconds since the exposure began
   * @param node DEF of the sensor that was entered or left, or of the Switch
   * @param choice the choice that the Switch shows from then on; -1 for none
   */
  public record SceneEvent(double t, Kind kind, String node, int choice) {
    /** Kinds of events, spelled in lower case in records. */
    public enum Kind {
      ENTER,
      EXIT,
      SWITCH
    }
  }

  /** Returns the time of the last frame. */
  double end() {
    return frames.get(frames.size() - 1).t();
  }

  /** Returns the time by the page's monotonic clock at which the exposure began. */
  double began() {
    return frames.get(0).mono() - frames.get(0).t();
  }

  /**
   * Returns the mean number of frames per second; 0 of a single frame. Frames that follow a pause,
   * in which nothing was logged, took no time.
   */
  double framesPerSecond() {
    double seconds = frames.stream().skip(1).mapToDouble(Frame::ms).sum() / 1000;
    long number = frames.stream().skip(1).filter(frame -> frame.ms() > 0).count();
    return seconds > 0 ? number / seconds : 0;
  }

  /** Returns whether a picture was seen at all. */
  boolean seen() {
    return frames.stream().anyMatch(Frame::visible);
  }

  /** Returns the share of the frames that took longer than a time. */
  double shareAbove(double milliseconds) {
    long slow = frames.stream().skip(1).filter(frame -> frame.ms() > milliseconds).count();
    return frames.size() > 1 ? (double) slow / (frames.size() - 1) : 0;
  }
}
