package org.selectiverenderer.authoring.images;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.authoring.SceneDocument;

class ImageSearchTest {
  private static final String SCENE =
      """
      <X3D version='3.3'><Scene>
        <Background frontUrl='"sky.png"'  backUrl='' />
        <Shape><Appearance><ImageTexture url='"C:\\maps\\Wood.PNG" "http://example.org/wood.png"'/>
        </Appearance></Shape>
        <Shape><Appearance><ImageTexture url="&quot;gone.jpg&quot;"/></Appearance></Shape>
        <Shape><Appearance><ImageTexture url='"data:image/png;base64,AAAA"'/></Appearance></Shape>
      </Scene></X3D>
      """;

  @TempDir Path folder;

  @Test
  void theNameOfAFileIsThatBehindItsPercentSigns() {
    assertThat(ImageReference.fileName("maps/my%20wood.png")).hasValue("my wood.png");
    assertThat(ImageReference.fileName("a+b%2.png")).hasValue("a+b%2.png");
  }

  @Test
  void missingImagesAreFoundByNameAndNamedRelativeToTheScene() throws IOException {
    SceneDocument document = SceneDocument.of("a.x3d", SCENE.getBytes(StandardCharsets.UTF_8));
    List<ImageReference> references = ImageReference.in(document);
    assertThat(references)
        .extracting(ImageReference::field)
        .containsExactly("frontUrl", "url", "url", "url");
    Path deep = Files.createDirectories(folder.resolve("a/deeper"));
    Files.write(deep.resolve("wood.png"), new byte[1]);
    Path wood = Files.write(folder.resolve("a/wood.png"), new byte[1]);
    Path sky = Files.write(folder.resolve("sky.png"), new byte[1]);
    List<String> names =
        references.stream()
            .flatMap(each -> ImageReference.fileName(each.urls().get(0)).stream())
            .toList();
    assertThat(names).containsExactly("sky.png", "Wood.PNG", "gone.jpg");
    Map<String, Path> found = ImageSearch.find(folder, names, () -> false);
    assertThat(found).containsOnly(Map.entry("sky.png", sky), Map.entry("Wood.PNG", wood));

    Map<ImageReference, Path> chosen = new HashMap<>();
    chosen.put(references.get(0), sky);
    chosen.put(references.get(1), wood);
    document.perform(ImageUrlEdit.of(document, chosen, folder));
    assertThat(document.text().toString())
        .isEqualTo(SCENE.replace("C:\\maps\\Wood.PNG", "a/wood.png"));
    document.history().undo();
    assertThat(document.text().toString()).isEqualTo(SCENE);
  }
}
