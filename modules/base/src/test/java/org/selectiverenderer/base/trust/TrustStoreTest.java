package org.selectiverenderer.base.trust;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.trust.PermissionRequest.Kind;

class TrustStoreTest {
  private static final PermissionRequest FOLDER =
      new PermissionRequest(Kind.FOLDER, "allow", "/data", "lets scenes read /data");
  private static final PermissionRequest HOST =
      new PermissionRequest(Kind.HOST, "allowNet", "example.org", "lets scenes fetch");

  @TempDir private Path settings;

  private static PermissionRequests of(String folder, PermissionRequest... list) {
    return new PermissionRequests(Path.of(folder), List.of(list));
  }

  @Test
  void theSameRequestsOfTheSameFolderAreRememberedInAnyOrder() throws IOException {
    TrustStore first = new TrustStore(settings);
    first.remember(of("/a", FOLDER));
    assertThat(first.remembers(of("/a", FOLDER, HOST))).as("a request more").isFalse();
    first.remember(of("/a", FOLDER, HOST));
    TrustStore later = new TrustStore(settings);
    assertThat(later.remembers(of("/a", HOST, FOLDER, FOLDER))).isTrue();
    assertThat(later.remembers(of("/b", FOLDER, HOST))).as("another folder").isFalse();
    assertThat(later.remembers(of("/a", FOLDER))).as("a request less").isTrue();
    later.remember(of("/b", FOLDER, HOST));
    assertThat(later.remembers(of("/a", FOLDER, HOST))).isTrue();
    assertThat(later.remembers(of("/b", FOLDER, HOST))).isTrue();
  }

  @Test
  void theAnswersAreTheUsersOwn() throws IOException {
    assumeThat(settings.getFileSystem().supportedFileAttributeViews()).contains("posix");
    TrustStore store = new TrustStore(settings.resolve("new"));
    for (String folder : List.of("/a", "/b")) {
      store.remember(of(folder, FOLDER));
      assertThat(permissions(settings.resolve("new"))).isEqualTo("rwx------");
      assertThat(permissions(settings.resolve("new").resolve(TrustStore.NAME)))
          .isEqualTo("rw-------");
    }
  }

  private static String permissions(Path path) throws IOException {
    return PosixFilePermissions.toString(Files.getPosixFilePermissions(path));
  }

  @Test
  @DisabledOnOs(value = OS.WINDOWS, disabledReason = "no name holds a line end there")
  void aFolderCannotForgeALineOfTheAnswers() throws IOException {
    TrustStore store = new TrustStore(settings);
    String digest = of("/victim", FOLDER).digests().iterator().next();
    store.remember(of("/a\n" + digest + " /victim", FOLDER));
    assertThat(store.remembers(of("/victim", FOLDER))).isFalse();
  }

  @Test
  void aLineShowsSignsThatWouldChangeIt() {
    assertThat(
            new PermissionRequest(
                Kind.FILE, "items", "x", "reads /a\u001b[2J\n\u202eb\u00a0\u2800\u3164c"))
        .hasToString("\"items\" reads /a\\u{1b}[2J\\u{a}\\u{202e}b\\u{a0}\\u{2800}\\u{3164}c");
  }
}
