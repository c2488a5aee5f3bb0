package org.selectiverenderer.runtime.sound;

/**
 * A sound that is heard in a frame.
 *
 * @param source tells sounds apart, by identity: the same in every frame
 * @param position seconds from the beginning of the recording, at the recording's own rate
 * @param pitch how much faster than at its own rate it is played
 * @param loop whether it begins again at its end
 * @param left gain of the left ear
 * @param right gain of the right ear
 * @param apart whether the recording's channels go to an ear each; else both go to both
 * @param rank of two sounds the one with the higher rank is heard where not all can be
 */
public record Voice(
    Object source,
    Recording recording,
    double position,
    double pitch,
    boolean loop,
    double left,
    double right,
    boolean apart,
    Rank rank) {

  /**
   * Which sounds are heard where not all can be (X3D 4.0, 16.2.2).
   *
   * @param priority 0 to 1
   * @param age seconds since it began; of sounds of a priority above 0.5 the newer comes first
   * @param intensity at the viewer
   */
  public record Rank(double priority, double age, double intensity) implements Comparable<Rank> {
    private static final double CUE = 0.5;

    /** The first to be heard is the smallest. */
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
