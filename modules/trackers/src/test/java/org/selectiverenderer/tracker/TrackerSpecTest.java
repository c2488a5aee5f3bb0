package org.selectiverenderer.tracker;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class TrackerSpecTest {
  @Test
  void everyKindIsRead() {
    assertThat(TrackerSpec.parse("none")).isEqualTo(new TrackerSpec.None());
    assertThat(TrackerSpec.parse("intertrax2:/dev/ttyUSB0"))
        .isEqualTo(new TrackerSpec.InterTrax2("/dev/ttyUSB0"));
    assertThat(TrackerSpec.parse("INTERTRAX2:COM3")).isEqualTo(new TrackerSpec.InterTrax2("COM3"));
    assertThat(TrackerSpec.parse("fastrak:/dev/ttyS0@115200"))
        .isEqualTo(new TrackerSpec.Fastrak("/dev/ttyS0", 115200));
    assertThat(TrackerSpec.parse("fastrak:/dev/ttyS0"))
        .isEqualTo(new TrackerSpec.Fastrak("/dev/ttyS0", 9600));
    assertThat(TrackerSpec.parse("opentrack:5000")).isEqualTo(new TrackerSpec.OpenTrack(5000));
    assertThat(TrackerSpec.parse("opentrack")).isEqualTo(new TrackerSpec.OpenTrack(4242));
    assertThat(TrackerSpec.parse("opentrack:*:4242"))
        .isEqualTo(new TrackerSpec.OpenTrack("*", 4242))
        .hasToString("opentrack:*:4242");
    assertThat(TrackerSpec.parse("opentrack:[::1]:4242"))
        .isEqualTo(new TrackerSpec.OpenTrack("::1", 4242))
        .hasToString("opentrack:[::1]:4242");
    assertThat(TrackerSpec.parse("vrpn:Tracker0@lab"))
        .isEqualTo(new TrackerSpec.Vrpn("Tracker0", "lab", 3883));
    assertThat(TrackerSpec.parse("vrpn:Tracker0@[::1]:4000"))
        .isEqualTo(new TrackerSpec.Vrpn("Tracker0", "::1", 4000));
    assertThat(TrackerSpec.parse("tcp:127.0.0.1:99"))
        .isEqualTo(new TrackerSpec.Tcp("127.0.0.1", 99));
    assertThat(TrackerSpec.parse("replay:a:b.csv"))
        .isEqualTo(new TrackerSpec.Replay(Path.of("a:b.csv")));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "none",
        "intertrax2:/dev/ttyUSB0",
        "fastrak:/dev/ttyUSB0@9600",
        "opentrack:4242",
        "vrpn:Tracker0@host:3883",
        "vrpn:Tracker0@[::1]:3883",
        "tcp:host:1",
        "replay:FILE.csv"
      })
  void isWrittenAsItIsRead(String text) {
    assertThat(TrackerSpec.parse(text)).hasToString(text);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '"',
      value = {
        "interstellar:/dev/x | there is no tracker of the kind 'interstellar'; write it like inter",
        "openxr | a headset brings its own tracker; leave --tracker out with run SCENE --display",
        "intertrax2 | the serial port is missing; write it like intertrax2:",
        "fastrak:/dev/x@fast | 'fast' is not a speed in bits per second (110 to 4000000)",
        "fastrak:@9600 | the serial port is missing",
        "opentrack:0 | '0' is not a port (1 to 65535); write it like opentrack:4242",
        "opentrack:65536 | '65536' is not a port",
        "vrpn:host | the tracker's name and '@' are missing before the host",
        "vrpn:T@:3883 | the host is missing",
        "tcp:host | the port is missing; write it like tcp:localhost:5555",
        "tcp:[::1] | the port is missing",
        "tcp::80 | the host is missing",
        "replay: | the file is missing; write it like replay:head.csv",
        "none:x | nothing may follow 'none'"
      })
  void whatCannotBeReadIsRefusedWithAnExample(String text, String sentence) {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> TrackerSpec.parse(text))
        .withMessageStartingWith("'" + text + "' is not a tracker: ")
        .withMessageContaining(sentence);
  }

  @ParameterizedTest
  @CsvSource({
    "Linux, /dev/ttyUSB0",
    "Mac OS X, /dev/cu.usbserial-10",
    "Windows 11, COM3",
  })
  void theExampleOfAPortIsOneOfTheSystem(String system, String port) {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new TrackerSpecParser("fastrak", system).parse())
        .withMessageEndingWith("write it like fastrak:" + port + "@9600");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new TrackerSpecParser("intertrax:1", system).parse())
        .withMessageContaining("write it like intertrax2:" + port + ", fastrak:" + port + "@9600,");
  }
}
