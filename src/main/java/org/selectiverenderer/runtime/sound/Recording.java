package org.selectiverenderer.runtime.sound;

/**
 * A sound as samples. Nobody changes them.
 *
 * @param samples frame after frame, in each one for every channel: left, right
 * @param channels 1 or 2
 * @param rate frames per second
 */
public record Recording(short[] samples, int channels, double rate) {
  /** How many samples each channel has. */
  public int frames() {
    return samples.length / channels;
  }

  /** How long it takes at its own rate. */
  public double seconds() {
    return frames() / rate;
  }

  /**
   * A channel's sample between two frames.
   *
   * @param at a frame, 0 to {@link #frames()} without it; behind the last one lies the first
   */
  double sample(int channel, double at) {
    int before = (int) at;
    int after = before + 1 < frames() ? before + 1 : 0;
    double low = samples[before * channels + channel];
    return low + (at - before) * (samples[after * channels + channel] - low);
  }
}
