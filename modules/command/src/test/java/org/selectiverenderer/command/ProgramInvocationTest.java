package org.selectiverenderer.command;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Properties;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** An example can be copied as it is printed. */
class ProgramInvocationTest {
  private static final String EXAMPLE = "Example:\n  ./selective-renderer run room.x3d\n";

  private static Properties of(String key, String value) {
    Properties properties = new Properties();
    properties.setProperty("os.name", "Linux");
    properties.setProperty(key, value);
    return properties;
  }

  @Test
  void amongTheSourcesItIsTheLauncherOfTheFolder() {
    assertThat(ProgramInvocation.in(EXAMPLE, of("os.name", "Mac OS X"))).isEqualTo(EXAMPLE);
  }

  @ParameterizedTest
  @CsvSource({
    "selective-renderer.installed, true",
    "jpackage.app-path, /opt/Selective Renderer",
    "os.name, Windows 11"
  })
  void elsewhereItIsTheNameAlone(String key, String value) {
    assertThat(ProgramInvocation.in(EXAMPLE, of(key, value)))
        .isEqualTo("Example:\n  selective-renderer run room.x3d\n");
  }

  @Test
  void onWindowsACommandIsOneLine() {
    String example = "  ./selective-renderer run room.x3d \\\r\n      --mute\r\n";
    assertThat(ProgramInvocation.in(example, of("os.name", "Windows 11")))
        .isEqualTo("  selective-renderer run room.x3d --mute\r\n");
    assertThat(ProgramInvocation.in(example, of("os.name", "Linux"))).isEqualTo(example);
  }

  @ParameterizedTest
  @CsvSource({"Linux, /dev/ttyUSB0", "Mac OS X, /dev/cu.usbserial-10", "Windows 11, COM3"})
  void aSerialPortIsNamedAsOnTheSystem(String system, String port) {
    assertThat(ProgramInvocation.in("track intertrax2:/dev/ttyUSB0", of("os.name", system)))
        .isEqualTo("track intertrax2:" + port);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "Linux | /home/a/b.x3d | /home/a/b.x3d",
        "Linux | my room.x3d | 'my room.x3d'",
        "Linux | it's | 'it'\\''s'",
        "Windows 11 | C:\\a\\b.x3d | C:\\a\\b.x3d",
        "Windows 11 | C:\\σκηνή.x3d | C:\\σκηνή.x3d",
        "Windows 11 | C:\\my room\\b.x3d | \"C:\\my room\\b.x3d\"",
        "Windows 11 | a&b.x3d | \"a&b.x3d\"",
        "Windows 11 | C:\\my room\\ | \"C:\\my room\\\\\"",
      })
  void aWordIsQuotedAsTheSystemsShellWantsIt(String system, String word, String quoted) {
    assertThat(ProgramInvocation.quoted(word, of("os.name", system))).hasValue(quoted);
  }

  /** The name of a file by a stranger is not run by whoever types the line. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "a$(calc).x3d",
        "%PATH%.x3d",
        "a `b.x3d",
        "a! b.x3d",
        "a \u201d; calc; \u201c.x3d"
      })
  void aWordThatAShellOfWindowsRunsIsNotWritten(String word) {
    assertThat(ProgramInvocation.quoted(word, of("os.name", "Windows 11"))).isEmpty();
  }
}
