package org.selectiverenderer.render.context;

import static org.assertj.core.api.Assertions.assertThat;

import com.jogamp.common.os.NativeLibrary;
import com.jogamp.common.os.Platform;
import com.jogamp.opengl.GLProfile;
import java.nio.file.Path;
import java.util.Collection;
import java.util.List;
import java.util.Objects;
import java.util.jar.JarFile;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.EnumSource.Mode;
import org.selectiverenderer.base.files.ProgramLocation;
import org.selectiverenderer.base.natives.NativePlatform;

class JoglNativeLibrariesTest {
  /** Else JOGL would load one that nobody has compared, or miss one. */
  @ParameterizedTest
  @EnumSource(mode = Mode.EXCLUDE, names = "WINDOWS_ARM64")
  void allThatItsJarsHaveForAPlatformAreNamed(NativePlatform platform) throws Exception {
    List<String> named = JoglNativeLibraries.resources(platform);
    String folder = named.get(0).substring(0, named.get(0).lastIndexOf('/') + 1);
    assertThat(Stream.concat(inJars(Platform.class, folder), inJars(GLProfile.class, folder)))
        .containsExactlyInAnyOrderElementsOf(named);
  }

  /** The native parts of a library are in jars beside its own, whose names say their platforms. */
  private static Stream<String> inJars(Class<?> library, String folder) throws Exception {
    Path jar = ProgramLocation.of(library).orElseThrow();
    String platform = folder.split("/")[1];
    Path natives =
        jar.resolveSibling(
            jar.getFileName().toString().replace(".jar", "-natives-" + platform + ".jar"));
    try (JarFile file = new JarFile(natives.toFile())) {
      Collection<String> names = file.stream().map(ZipEntry::getName).toList();
      return names.stream().filter(name -> name.startsWith(folder) && !name.endsWith("/"));
    }
  }

  /** It may be the folder of a scene that somebody else has sent, with a library of his. */
  @Test
  void theCurrentDirectoryIsNotSearched() {
    String current = Path.of("").toAbsolutePath().toString();
    JoglNativeLibraries.use();
    assertThat(NativeLibrary.enumerateLibraryPaths("OpenGL32", "libGL.so.1", "GL", null))
        .extracting(place -> place.path)
        .isNotEmpty()
        .noneMatch(path -> path.startsWith(current) || !Path.of(path).isAbsolute());
  }

  @ParameterizedTest
  @EnumSource(mode = Mode.EXCLUDE, names = "WINDOWS_ARM64")
  void theyAreOnTheClassPath(NativePlatform platform) {
    ClassLoader loader = Objects.requireNonNull(JoglNativeLibraries.class.getClassLoader());
    assertThat(JoglNativeLibraries.resources(platform))
        .allSatisfy(name -> assertThat(loader.getResource(name)).as(name).isNotNull());
  }
}
