package org.selectiverenderer.browser.sound;

import java.io.IOException;
import javax.sound.sampled.AudioFormat;
import javax.sound.sampled.AudioSystem;
import javax.sound.sampled.LineUnavailableException;
import javax.sound.sampled.SourceDataLine;

/** The output line of the machine's sound device. */
public final class SoundDeviceLine implements SoundLine {
  private static final AudioFormat FORMAT = new AudioFormat(RATE, 16, 2, true, false);

  /** Size of the output buffer in bytes: a tenth of a second, which is the latency of sounds. */
  private static final int BUFFER = 4096 * FORMAT.getFrameSize();

  private final SourceDataLine line;

  private SoundDeviceLine(SourceDataLine line) {
    this.line = line;
  }

  /**
   * Opens the default sound device.
   *
   * @throws IOException with a clause as message if there is none or another program uses it
   *     exclusively
   */
  public static SoundDeviceLine open() throws IOException {
    try {
      SourceDataLine line = AudioSystem.getSourceDataLine(FORMAT);
      line.open(FORMAT, BUFFER);
      line.start();
      return new SoundDeviceLine(line);
    } catch (LineUnavailableException e) {
      throw new IOException("the sound device is in use", e);
    } catch (IllegalArgumentException e) { // Thrown if there is no device.
      throw new IOException("this machine has no sound device", e);
    }
  }

  @Override
  public boolean write(byte[] samples, int length) {
    return line.write(samples, 0, length) == length;
  }

  @Override
  public void close() {
    line.stop();
    line.flush();
    line.close();
  }
}
