package org.selectiverenderer.doctor.probe;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.selectiverenderer.browser.sound.SoundDeviceLine;
import org.selectiverenderer.browser.sound.SoundDevices;
import org.selectiverenderer.doctor.Diagnosis;
import org.selectiverenderer.lsl.LslLibrary;

/** Checks the Lab Streaming Layer and the sound devices. */
final class LslAndSoundProbe {
  private LslAndSoundProbe() {}

  static void lsl(Consumer<Diagnosis> found) {
    try {
      int version = LslLibrary.open(Optional.empty()).version();
      found.accept(Diagnosis.ok("liblsl", "%d.%d".formatted(version / 100, version % 100)));
    } catch (IOException e) {
      found.accept(Diagnosis.missing("liblsl", String.valueOf(e.getMessage()), ""));
    }
  }

  static void sound(Consumer<Diagnosis> found) {
    List<String> names = SoundDevices.names();
    try {
      SoundDeviceLine.open().close();
      found.accept(Diagnosis.ok("sound", String.join(", ", names)));
    } catch (IOException e) {
      found.accept(
          Diagnosis.missing(
              "sound",
              e.getMessage() + (names.isEmpty() ? "" : " (" + String.join(", ", names) + ")"),
              "to hear scenes connect a sound device, or free it; without one they are silent"));
    }
  }
}
