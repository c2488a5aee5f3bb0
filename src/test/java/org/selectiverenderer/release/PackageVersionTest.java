package org.selectiverenderer.release;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What the packages of Linux call a version: there a tilde comes before nothing. */
@DisabledOnOs(OS.WINDOWS)
class PackageVersionTest {
  private static final String ASK =
      "eval \"$(sed -n '/^plain_version()/,/^}/p' packaging/parts/linux)\"; version=$1; plain_version";

  @ParameterizedTest
  @CsvSource({
    "1.2.0, 1.2.0",
    "1.2.0-rc.1, 1.2.0~rc.1",
    "1.2.1-SNAPSHOT, 1.2.1~snapshot",
    "1.2.1-SNAPSHOT+1a2b3c4d5.changed, 1.2.1~snapshot+1a2b3c4d5.changed",
    "1.2.0-rc-1, 1.2.0~rc+1"
  })
  void whatLeadsToAReleaseComesBeforeIt(String version, String plain) throws Exception {
    Process bash =
        new ProcessBuilder("bash", "-c", ASK, "ask", version).redirectErrorStream(true).start();
    String said = new String(bash.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertThat(said.strip()).isEqualTo(plain);
    assertThat(bash.waitFor()).isZero();
  }
}
