package org.selectiverenderer.base.files;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

@DisabledOnOs(value = OS.WINDOWS, disabledReason = "its folders have no modes")
class PrivateFolderTest {
  @TempDir private Path temporary;
  private Path place;

  @BeforeEach
  void withoutLinks() throws IOException {
    place = temporary.toRealPath();
  }

  @Test
  void whatIsMadeIsOfThisUserAlone() throws Exception {
    Path made = PrivateFolder.make(place.resolve("cache"), "program", "natives");
    assertThat(made).isEqualTo(place.resolve("cache/program/natives"));
    for (Path each : new Path[] {made, made.getParent(), made.getParent().getParent()}) {
      assertThat(mode(each)).isEqualTo("rwx------");
    }
    assertThat(PrivateFolder.make(place.resolve("cache"), "program", "natives")).isEqualTo(made);
  }

  @Test
  void aFolderThatOthersMayWriteToIsRefused() throws Exception {
    Path open = Files.createDirectory(place.resolve("program"));
    mode(open, "rwxrwxrwx");
    assertThatThrownBy(() -> PrivateFolder.make(place, "program"))
        .isInstanceOf(IOException.class)
        .hasMessage(
            "others may write to %s (mode 0777): type chmod go-w '%s'".formatted(open, open));
    assertThatThrownBy(() -> PrivateFolder.make(place, "program", "natives"))
        .hasMessageContaining("others may write to " + open);
    mode(open, "rwxrwx---");
    assertThatThrownBy(() -> PrivateFolder.make(place, "program"))
        .hasMessageContaining("mode 0770");
  }

  @Test
  void aLinkIsRefused() throws Exception {
    Path elsewhere = Files.createDirectory(place.resolve("elsewhere"));
    Path link = Files.createSymbolicLink(place.resolve("program"), elsewhere);
    assertThatThrownBy(() -> PrivateFolder.make(place, "program"))
        .hasMessage(link + " is a link or a file, not a folder: delete it");
    assertThatThrownBy(() -> PrivateFolder.make(place, "program", "natives"))
        .hasMessageStartingWith(link + " is a link");
  }

  /** A user may have his caches on another disk; what counts is where the link leads. */
  @Test
  void thePlaceMayBeALink() throws Exception {
    Path disk = Files.createDirectory(place.resolve("disk"));
    Path link = Files.createSymbolicLink(place.resolve("cache"), disk);
    assertThat(PrivateFolder.make(link, "program")).isEqualTo(disk.resolve("program"));
  }

  @Test
  void aFolderAboveMayBeOpenIfItIsSticky() throws Exception {
    Path above = Files.createDirectory(place.resolve("above"));
    mode(above, "rwxrwxrwx");
    assertThatThrownBy(() -> PrivateFolder.make(above, "program")).hasMessageContaining("" + above);
    Files.setAttribute(above, "unix:mode", 01777);
    assertThat(PrivateFolder.make(above, "program")).isDirectory();
    assertThat(PrivateFolder.fault(above)).as("not the innermost").isPresent();
  }

  @Test
  void aFolderOfAnotherUserIsRefused() throws Exception {
    Path folder = Files.createDirectory(place.resolve("program"));
    int user = PrivateFolder.user().orElseThrow();
    assertThat(PrivateFolder.fault(folder, Optional.of(user))).isEmpty();
    Optional<String> fault = PrivateFolder.fault(folder, Optional.of(user + 1));
    if (user == 0) {
      assertThat(fault).as("the administrator's").isEmpty();
      Files.setAttribute(folder, "unix:uid", 1234);
      fault = PrivateFolder.fault(folder);
    }
    assertThat(fault.orElseThrow()).startsWith(folder + " belongs to another user (number ");
  }

  @Test
  void aFileIsClosedWhenOthersCannotChangeIt() throws Exception {
    Path file = Files.writeString(place.resolve("library"), "code");
    mode(file, "rw-r--r--");
    assertThat(PrivateFolder.closed(file)).isTrue();
    assertThat(PrivateFolder.closed(Files.createSymbolicLink(place.resolve("link"), file)))
        .isFalse();
    mode(file, "rw-rw-r--");
    assertThat(PrivateFolder.closed(file)).isFalse();
    assertThat(PrivateFolder.closed(place.resolve("missing"))).isFalse();
  }

  private static String mode(Path file) throws IOException {
    return PosixFilePermissions.toString(Files.getPosixFilePermissions(file));
  }

  private static void mode(Path file, String mode) throws IOException {
    Files.setPosixFilePermissions(file, PosixFilePermissions.fromString(mode));
  }
}
