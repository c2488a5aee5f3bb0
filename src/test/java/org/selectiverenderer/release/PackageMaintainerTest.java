package org.selectiverenderer.release;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** Whom packages name for what they contain: the first author of CITATION.cff. */
@DisabledOnOs(OS.WINDOWS)
class PackageMaintainerTest {
  private static final String ASK =
      "eval \"$(sed -n '/^author()/,/^}/p; /^maintainer()/,/^}/p' \"$1\")\"; maintainer";

  @TempDir Path folder;

  private String maintainer(String citation) throws IOException, InterruptedException {
    Files.writeString(folder.resolve("CITATION.cff"), citation);
    String script = Path.of("packaging/package").toAbsolutePath().toString();
    Process bash =
        new ProcessBuilder("bash", "-c", ASK, "ask", script)
            .directory(folder.toFile())
            .redirectErrorStream(true)
            .start();
    String said = new String(bash.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertThat(bash.waitFor()).as(said).isZero();
    return said.stripTrailing();
  }

  @Test
  void aGroupWithAnAddress() throws Exception {
    assertThat(
            maintainer(
                """
                title: A
                authors:
                  # Who makes it.
                  - name: "The Selective Renderer authors"
                    email: makers@example.org # read on weekdays
                  - given-names: B.
                    family-names: Other
                    email: other@example.org
                version: 0.1.0
                """))
        .isEqualTo("The Selective Renderer authors <makers@example.org>");
  }

  @Test
  void aPersonWhosePartsAreNamedInAnyOrder() throws Exception {
    assertThat(
            maintainer(
                """
                authors:
                - family-names: Beethoven
                  name-particle: van
                  email: 'l@example.org'
                  given-names: Ludwig
                references:
                  - authors:
                      - name: Somebody else
                """))
        .isEqualTo("Ludwig van Beethoven <l@example.org>");
  }

  @Test
  void noAddressIsMadeUp() throws Exception {
    assertThat(maintainer(Files.readString(Path.of("CITATION.cff"))))
        .startsWith("The Selective Renderer authors")
        .doesNotContain("localhost", "<>");
    assertThat(maintainer("authors:\n  - name: A. Zotos\nversion: 1\n")).isEqualTo("A. Zotos");
  }
}
