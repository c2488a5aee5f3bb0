package org.selectiverenderer.cli;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.Charset;
import java.util.Properties;
import org.junit.jupiter.api.Test;

class TerminalEncodingTest {
  private static Properties of(String... pairs) {
    Properties properties = new Properties();
    properties.setProperty("native.encoding", "Cp1253");
    for (int at = 0; at < pairs.length; at += 2) {
      properties.setProperty(pairs[at], pairs[at + 1]);
    }
    return properties;
  }

  private static Charset charset(boolean terminal, String... pairs) {
    return TerminalEncoding.charset(of(pairs), "stdout", terminal);
  }

  @Test
  void aConsoleWindowOfWindowsGetsItsCodePage() {
    Charset greek = Charset.forName("Cp737");
    assertThat(charset(true, "os.name", "Windows 11", "stdout.encoding", "cp737")).isEqualTo(greek);
    assertThat(charset(true, "os.name", "Windows 10", "sun.stdout.encoding", "cp737"))
        .isEqualTo(greek);
    // Standard input alone is redirected.
    assertThat(charset(false, "os.name", "Windows 11", "stdout.encoding", "cp737"))
        .isEqualTo(greek);
  }

  @Test
  void pipesFilesAndOtherSystemsGetUtf8() {
    assertThat(charset(false, "os.name", "Windows 11", "stdout.encoding", "Cp1253"))
        .isEqualTo(UTF_8);
    assertThat(charset(false, "os.name", "Windows 10")).isEqualTo(UTF_8);
    assertThat(charset(true, "os.name", "Windows 11", "stdout.encoding", "cp0")).isEqualTo(UTF_8);
    assertThat(charset(true, "os.name", "Linux", "stdout.encoding", "ISO-8859-7")).isEqualTo(UTF_8);
  }

  /**
   * In {@code validate x 2>log.txt} standard output is a console window and messages are a file.
   */
  @Test
  void messagesInAFileAreUtf8ThoughDataAreShown() {
    Properties file =
        of("os.name", "Windows 11", "stdout.encoding", "cp737", "stderr.encoding", "Cp1253");
    assertThat(TerminalEncoding.charset(file, "stderr", true)).isEqualTo(UTF_8);
    Properties shown =
        of("os.name", "Windows 11", "stdout.encoding", "cp737", "stderr.encoding", "cp737");
    assertThat(TerminalEncoding.charset(shown, "stderr", true)).isEqualTo(Charset.forName("Cp737"));
  }

  @Test
  void textIsEncodedHoweverItIsCut() throws IOException {
    ByteArrayOutputStream shown = new ByteArrayOutputStream();
    OutputStream stream =
        TerminalEncoding.of(
            of("os.name", "Windows 11", "stdout.encoding", "cp737"), "stdout", true, shown);
    for (byte piece : "Σκηνή\u001b[1m \u65e5\n".getBytes(UTF_8)) {
      stream.write(piece);
    }
    stream.write("Τέλος".getBytes(UTF_8));
    assertThat(shown.toString(Charset.forName("Cp737"))).isEqualTo("Σκηνή\u001b[1m ?\nΤέλος");
  }
}
