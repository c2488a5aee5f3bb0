package org.selectiverenderer.browser.sound;

import java.util.Arrays;
import java.util.List;
import javax.sound.sampled.AudioSystem;
import javax.sound.sampled.Line;
import javax.sound.sampled.Mixer;
import javax.sound.sampled.SourceDataLine;

/** Lists the sound devices of the machine. */
public final class SoundDevices {
  private static final Line.Info PLAYS = new Line.Info(SourceDataLine.class);

  private SoundDevices() {}

  /** Returns the names of the playback devices, the default one first. */
  public static List<String> names() {
    return Arrays.stream(AudioSystem.getMixerInfo())
        .filter(device -> AudioSystem.getMixer(device).isLineSupported(PLAYS))
        .map(Mixer.Info::getName)
        .toList();
  }
}
