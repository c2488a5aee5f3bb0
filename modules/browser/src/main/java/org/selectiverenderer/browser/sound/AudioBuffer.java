package org.selectiverenderer.browser.sound;

/**
 * A decoded sound file: 16-bit PCM samples. Immutable.
 *
 * @param samples the samples, interleaved by channel: left, right
 * @param channels the number of channels, 1 or 2
 * @param rate the sample rate: frames per second
 */
public record AudioBuffer(short[] samples, int channels, double rate) {
  /** Returns the number of samples of each channel. */
  public int frames() {
    return samples.length / channels;
  }

  /** Returns the duration in seconds at the recording's own rate. */
  public double seconds() {
    return frames() / rate;
  }

  /**
   * Returns a channel's sample, interpolated between two frames.
   *
   * @param at the position in frames, from 0 to below {@link #frames()}; the last frame is followed
   *     by the first
   */
  double sample(int channel, double at) {
    int before = (int) at;
    int after = before + 1 < frames() ? before + 1 : 0;
    double low = samples[before * channels + channel];
    return low + (at - before) * (samples[after * channels + channel] - low);
  }
}
