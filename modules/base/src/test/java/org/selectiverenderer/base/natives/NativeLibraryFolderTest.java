package org.selectiverenderer.base.natives;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.Objects;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** What is unpacked here is a class file; a library's bytes are nothing else. */
class NativeLibraryFolderTest {
  private static final String NAME = "NativeLibraryFolderTest.class";
  private static final String RESOURCE = "org/selectiverenderer/base/natives/" + NAME;

  @TempDir private Path cache;

  @Test
  void librariesLieInTheCacheOfTheUser() throws Exception {
    Path folder = unpack();
    assertThat(folder.getParent())
        .isEqualTo(cache.toRealPath().resolve("selective-renderer/natives"));
    assertThat(folder.getFileName().toString()).matches("thing-[0-9a-f]{8}");
    assertThat(folder.resolve(NAME)).hasBinaryContent(bytes());
  }

  @Test
  void whatIsUnchangedIsNotWrittenAgain() throws Exception {
    Path library = unpack().resolve(NAME);
    Object file = Files.readAttributes(library, BasicFileAttributes.class).fileKey();
    unpack();
    assertThat(Files.readAttributes(library, BasicFileAttributes.class).fileKey()).isEqualTo(file);
  }

  @Test
  void whatIsChangedIsReplaced() throws Exception {
    Path library = unpack().resolve(NAME);
    byte[] content = bytes();
    content[content.length / 2]++;
    Files.write(library, content);
    assertThat(unpack().resolve(NAME)).hasBinaryContent(bytes());
    Files.write(library, new byte[3]);
    assertThat(unpack().resolve(NAME)).hasBinaryContent(bytes());
  }

  /** Who owns a file may change it after it was compared. */
  @Test
  @DisabledOnOs(value = OS.WINDOWS, disabledReason = "its files have no modes")
  void whatOthersMayChangeIsReplacedThoughItIsTheSame() throws Exception {
    Path library = unpack().resolve(NAME);
    Files.setPosixFilePermissions(library, PosixFilePermissions.fromString("rw-rw-rw-"));
    unpack();
    assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(library)))
        .isEqualTo("rw-------");

    Path elsewhere = Files.write(cache.resolve("elsewhere"), bytes());
    Files.delete(library);
    Files.createSymbolicLink(library, elsewhere);
    unpack();
    assertThat(Files.isSymbolicLink(library)).isFalse();
    assertThat(elsewhere).hasBinaryContent(bytes());
  }

  @Test
  @DisabledOnOs(value = OS.WINDOWS, disabledReason = "its folders have no modes")
  void aFolderThatOthersCanChangeIsRefusedInOneLine() throws Exception {
    Path folder = unpack().getParent();
    Files.setPosixFilePermissions(folder, PosixFilePermissions.fromString("rwxrwxrwx"));
    assertThatThrownBy(this::unpack)
        .isInstanceOf(UncheckedIOException.class)
        .cause()
        .hasMessage(
            "the native library thing is not loaded: others may write to %s (mode 0777): type"
                    .formatted(folder)
                + " chmod go-w '%s', or name another folder by XDG_CACHE_HOME".formatted(folder));
  }

  @Test
  void aMissingPartIsSaid() {
    assertThatThrownBy(
            () ->
                new NativeLibraryFolder(cache, "X")
                    .unpack(NativeLibraryFolderTest.class, "thing", List.of("no/such.so")))
        .cause()
        .hasMessage(
            "the native library thing is not loaded: the program was built without no/such.so");
  }

  private Path unpack() {
    return new NativeLibraryFolder(cache, "XDG_CACHE_HOME")
        .unpack(NativeLibraryFolderTest.class, "thing", List.of(RESOURCE));
  }

  private static byte[] bytes() throws IOException {
    try (InputStream in =
        Objects.requireNonNull(NativeLibraryFolderTest.class.getResourceAsStream(NAME))) {
      return in.readAllBytes();
    }
  }
}
