package org.selectiverenderer.browser.sound;

/**
 * A sound that is audible in a frame.
 *
 * @param source the identity of the sound: the same object in every frame
 * @param position the playback position in seconds from the beginning of the recording, at its own
 *     rate
 * @param pitch the factor of the playback rate
 * @param loop whether the recording is repeated
 * @param left the gain of the left ear
 * @param right the gain of the right ear
 * @param apart whether each of the recording's channels goes to one ear; otherwise both go to both
 * @param rank the rank, which decides what is played if there are too many sounds
 */
public record Voice(
    Object source,
    AudioBuffer recording,
    double position,
    double pitch,
    boolean loop,
    double left,
    double right,
    boolean apart,
    Rank rank) {

  /**
   * The rank of a sound, by which sounds are selected if not all can be played (X3D 4.0, 16.2.2).
   *
   * @param priority the priority, 0 to 1
   * @param age the seconds since the start; among sounds with a priority above 0.5 the newer comes
   *     first
   * @param intensity the intensity at the viewer
   */
  public record Rank(double priority, double age, double intensity) implements Comparable<Rank> {
    private static final double CUE = 0.5;

    /** Orders ranks by importance; the most important is the smallest. */
    @Override
    public int compareTo(Rank other) {
      int order = Double.compare(other.priority, priority);
      if (order == 0 && priority > CUE) {
        order = Double.compare(age, other.age);
      }
      return order != 0 ? order : Double.compare(other.intensity, intensity);
    }
  }
}
