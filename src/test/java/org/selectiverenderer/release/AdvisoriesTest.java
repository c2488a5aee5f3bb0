package org.selectiverenderer.release;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.release.ScriptSandbox.Run;
import org.selectiverenderer.testing.RequiresProgram;

/**
 * {@code packaging/advisories} on the SBOM and the jar of a door with a hinge and a native bolt.
 */
@DisabledOnOs(OS.WINDOWS)
@RequiresProgram("python3")
class AdvisoriesTest {
  private static final String ACCEPTED = "packaging/advisories-accepted.txt";
  private static final String COMMIT = "0123456789abcdef0123456789abcdef01234567";

  @TempDir private Path folder;
  private ScriptSandbox scripts;
  private OsvServer osv;

  @BeforeEach
  void aBuiltProgram() throws Exception {
    scripts = new ScriptSandbox(folder);
    scripts.copy("packaging/advisories", "packaging/releasing");
    scripts.write(
        "target/bom.json",
        """
        {"components": [
          {"group": "org.door", "name": "hinge", "version": "2.1",
           "purl": "pkg:maven/org.door/hinge@2.1?classifier=natives-linux&type=jar"},
          {"group": "org.selectiverenderer", "name": "a-module", "version": "1.2.0"}]}
        """);
    Path jar = scripts.home.resolve("target/selective-renderer.jar");
    try (ZipOutputStream out = new ZipOutputStream(Files.newOutputStream(jar))) {
      for (String system : new String[] {"linux", "macos"}) {
        out.putNextEntry(new ZipEntry("META-INF/" + system + "/x64/org/door/libbolt.so.git"));
        out.write((COMMIT + "\n").getBytes(StandardCharsets.US_ASCII));
      }
    }
    osv = new OsvServer();
    osv.answer("{\"results\": [{}, {}]}");
    scripts.environment.put("SELECTIVE_RENDERER_OSV", osv.address());
  }

  @AfterEach
  void noServer() {
    osv.close();
  }

  @Test
  void librariesAndNativePartsAreAskedFor() throws Exception {
    Run run = ask(0);
    assertThat(run.out())
        .isEqualTo("OSV knows no vulnerability of 2 components that is not accepted\n");
    assertThat(osv.asked())
        .containsExactly(
            "{\"queries\": [{\"package\": {\"purl\": \"pkg:maven/org.door/hinge@2.1\"}},"
                + " {\"commit\": \""
                + COMMIT
                + "\"}]}");
  }

  @Test
  void whatIsKnownIsListedUnlessItIsAccepted() throws Exception {
    osv.answer(
        "{\"results\": [{\"vulns\": [{\"id\": \"GHSA-1\"}]}, {\"vulns\": [{\"id\": \"OSV-2\"}]}]}");
    assertThat(ask(1).out())
        .isEqualTo(
            """
            libbolt.so@012345678: OSV-2 (https://osv.dev/OSV-2)
            org.door:hinge: GHSA-1 (https://osv.dev/GHSA-1)
            """);
    scripts.write(
        ACCEPTED,
        """
        # Looked at.
        org.door:hinge GHSA-1 until 2999-01-31: The door has no lock.
        libbolt.so OSV-2 until 2001-01-31: Only where it rains.
        """);
    assertThat(ask(1).out())
        .isEqualTo(
            "libbolt.so@012345678: OSV-2 (https://osv.dev/OSV-2),"
                + " accepted until 2001-01-31 because: Only where it rains.\n");
    scripts.write(ACCEPTED, scripts.read(ACCEPTED).replace("2001", "2999"));
    ask(0);
  }

  @Test
  void anAcceptedOneHasADayAndAReason() throws Exception {
    scripts.write(ACCEPTED, "\norg.door:hinge GHSA-1\n");
    assertThat(ask(2).err())
        .endsWith(ACCEPTED + ":2: a line is 'COMPONENT ID until YYYY-MM-DD: reason'\n");
    scripts.write(ACCEPTED, "org.door:hinge GHSA-1 until 2999-13-01: A reason.\n");
    assertThat(ask(2).err()).contains(ACCEPTED + ":1: ");
  }

  /** OSV gives long answers in pages. */
  @Test
  void aFurtherPageIsAskedFor() throws Exception {
    osv.answer(
        "{\"results\": [{\"vulns\": [{\"id\": \"A-1\"}], \"next_page_token\": \"more\"}, {}]}",
        "{\"results\": [{\"vulns\": [{\"id\": \"A-2\"}]}]}");
    assertThat(ask(1).out()).contains("org.door:hinge: A-1 ", "org.door:hinge: A-2 ");
    assertThat(osv.asked().get(1)).contains("\"page_token\": \"more\"");
  }

  @Test
  void thatNobodyAnswersIsSaid() throws Exception {
    for (String answer : new String[] {"<html>", "{\"results\": [{}]}", "[]"}) {
      osv.answer(answer);
      assertThat(ask(2).err()).as(answer).contains("OSV ").contains("known vulnerabilities");
    }
    osv.close();
    assertThat(ask(2).err())
        .contains("OSV could not be asked for known vulnerabilities (" + osv.address());
  }

  private Run ask(int status) throws IOException, InterruptedException {
    Run run = scripts.run("packaging/advisories");
    assertThat(run.status()).as(run.err()).isEqualTo(status);
    return run;
  }
}
