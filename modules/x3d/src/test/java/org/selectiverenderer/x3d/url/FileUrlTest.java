package org.selectiverenderer.x3d.url;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class FileUrlTest {
  @ParameterizedTest
  @CsvSource({
    "file:///C:/scenes/a.x3d, file:///C:/scenes/a.x3d",
    "file:///C:/My%20Scenes/a.x3d, file:///C:/My%20Scenes/a.x3d",
    "file:///C:/My Scenes/a.x3d, file:///C:/My%20Scenes/a.x3d",
    "file:///C:\\My Scenes\\a.x3d, file:///C:/My%20Scenes/a.x3d",
    "file://C:/scenes/a.x3d, file:///C:/scenes/a.x3d",
    "file:/C:/scenes/a.x3d, file:///C:/scenes/a.x3d",
    "file:C:\\scenes\\a.x3d, file:///C:/scenes/a.x3d",
    "FILE://localhost/C:/scenes/a.x3d, file:/C:/scenes/a.x3d",
    "file:/home/me/a [1] 50%.x3d, file:/home/me/a%20%5B1%5D%2050%25.x3d",
    "file:///home/me/Ä?.x3d, file:///home/me/%C3%84%3F.x3d"
  })
  void isWhatIsMeant(String url, String uri) {
    assertThat(FileUrl.uri(url)).hasToString(uri);
  }

  @ParameterizedTest
  @ValueSource(strings = {"file://server/share/a.x3d", "file:\\\\server\\share\\a.x3d"})
  void anotherComputerStaysOne(String url) {
    assertThat(FileUrl.uri(url).getAuthority()).isEqualTo("server");
  }

  @Test
  void aFolderWithASpaceNeedsNoCodes(@TempDir Path folder) throws IOException {
    Path scenes = Files.createDirectories(folder.resolve("my scenes ä"));
    Path file = Files.writeString(scenes.resolve("a.x3d"), "");
    String url = "file:///" + file.toRealPath().toString().replaceFirst("^/", "");

    assertThat(new UrlResolver(scenes).resolve(url, scenes))
        .isInstanceOf(UrlResolver.Target.Found.class);
  }
}
